import { useEffect, useRef } from 'preact/hooks';
import { Cancel } from '../../app/Cancel.tsx';
import { HeightCurve, hopsOf } from '../../app/HeightCurve.tsx';
import { PERCENT, rounded } from '../../format/quantity.ts';
import { hint, live, savedS, soFar } from '../../state/listening.ts';
import { phase } from '../../state/workspace.ts';
import { language, text } from '../../text/language.ts';
import { paintLive } from '../../wave/live-painter.ts';

/** The last seconds of the sound, scrolling; each impact is marked as soon as it is detected. */
export function LiveStrip() {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    let frame = 0;
    const step = (): void => {
      const now = live.peek();
      if (canvas.current && now) paintLive(canvas.current, now, soFar.peek());
      frame = requestAnimationFrame(step);
    };
    step();
    return () => cancelAnimationFrame(frame);
  }, []);
  return (
    <section class="stack wide">
      <p class="lead" role="status">
        <RunningSentence />
      </p>
      {phase.value.kind === 'listening' && (
        <HeightCurve hops={soFar.value?.drop ? hopsOf(soFar.value.drop) : []} leastS={2} />
      )}
      <canvas ref={canvas} class="live" aria-hidden="true" />
      {phase.value.kind === 'reading' ? (
        <>
          <Progress share={phase.value.share} />
          {phase.value.cancel && <Cancel onCancel={phase.value.cancel} />}
        </>
      ) : (
        <p class="soft">
          {text('page-lab-ends-itself')}{' '}
          {savedS.value > 0 && text('page-lab-saved', { seconds: Math.floor(savedS.value) })}
        </p>
      )}
    </section>
  );
}

/** The progress of reading a file. */
function Progress({ share }: { readonly share: number | undefined }) {
  return share === undefined ? null : (
    <progress value={share} max={1} aria-label={text('page-lab-progress')} />
  );
}

function RunningSentence() {
  const now = phase.value;
  if (now.kind === 'starting') return <>{text('page-lab-starting')}</>;
  if (now.kind === 'reading') return <>{text('page-lab-opening', { name: now.name })}</>;
  const count = soFar.value?.drop?.impacts.length ?? 0;
  if (count === 0) {
    return (
      <>
        {text('page-lab-listening')} {hint.value && text(`page-lab-hint-${hint.value}`)}
      </>
    );
  }
  const keeps = soFar.value?.drop?.log_linear_fit?.restitution.value;
  const share = keeps === undefined ? undefined : rounded(keeps, 3, PERCENT, language.value);
  return (
    <>
      {text('page-lab-so-far', { count })}
      {share !== undefined && `; ${text('page-lab-so-far-keeps', { share })}`}
    </>
  );
}
