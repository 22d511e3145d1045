import { useState } from 'preact/hooks';
import { Reported } from '../../app/Blocks.tsx';
import { Choice } from '../../app/Choice.tsx';
import { useAnswer, useLatest } from '../../chart/Figure.tsx';
import type { JudgedPlace, RuleChoice, Settings, VerdictRequest } from '../../lab/index.ts';
import { engine } from '../../state/engine.ts';
import { text } from '../../text/language.ts';
import { Kept } from './Kept.tsx';

/** A place with its drops, and the surface that it is of. */
export interface Place extends JudgedPlace {
  readonly surface: string;
}

interface VerdictProps {
  readonly settings: Settings;
  readonly places: readonly Place[];
}

/** Drops held against a rule: the verdict, what is not shown of the procedure, and the figure with the limits. */
export function Verdict({ settings, places }: VerdictProps) {
  const [name, setName] = useState('');
  const [kept, setKept] = useState<readonly string[]>([]);
  const [reference, setReference] = useState('');
  const rules = useAnswer(() => engine().rules(), null) ?? [];
  const rule = rules.find((choice) => choice.name === name);
  const hasBall = settings.ball?.kind !== undefined || settings.ball?.mass_kg !== undefined;
  const request = rule && (hasBall || rule.has_ball) ? requestOf(rule) : undefined;
  const { answer: judged, isCurrent } = useLatest(
    async () => request && engine().judge(request),
    request ?? null,
  );
  function requestOf({ rule, needs_reference }: RuleChoice): VerdictRequest {
    const isReference = ({ surface }: Place): boolean => needs_reference && surface === reference;
    return {
      rule,
      kept: [...kept],
      settings,
      surface: places.filter((place) => !isReference(place)),
      reference: places.filter(isReference),
      made: null,
    };
  }
  const surfaces = [...new Set(places.map(({ surface }) => surface))];
  return (
    <div class="stack wide verdict" aria-busy={request !== undefined && !isCurrent}>
      <div class="measures">
        <Choice
          label={text('page-verdict-rule')}
          value={name}
          options={[['', '…'], ...rules.map(({ name, title }) => [name, title] as const)]}
          onChange={(chosen) => {
            setName(chosen);
            setKept([]);
          }}
        />
        {rule?.needs_reference && (
          <Choice
            label={text('page-verdict-reference')}
            value={reference}
            options={[['', '…'], ...surfaces.map((surface) => [surface, surface] as const)]}
            onChange={setReference}
          />
        )}
      </div>
      {rule && !request && <p class="notice">{text('page-verdict-ball')}</p>}
      {request && judged && (
        <>
          <Kept parts={judged.stated} kept={kept} onChange={setKept} />
          <Reported
            {...judged}
            label={text('page-verdict-report')}
            name={name}
            report={(made) => engine().verdictReport({ ...request, made })}
          />
        </>
      )}
    </div>
  );
}
