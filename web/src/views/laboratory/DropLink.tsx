import { useState } from 'preact/hooks';
import { FaultNotice } from '../../app/FaultNotice.tsx';
import { HandOver } from '../../app/HandOver.tsx';
import type { DropLink as Link } from '../../lab/index.ts';
import { faultOf } from '../../state/engine.ts';
import type { Fault } from '../../state/faults.ts';
import { pupil } from '../../state/lesson.ts';
import { linkOfDrop } from '../../state/linking.ts';
import { analysed } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';

/** What was made of which drop. */
interface Made {
  readonly of: unknown;
  readonly name: string;
  readonly surface: string;
  readonly link?: Link;
  readonly fault?: Fault;
}

interface Props {
  readonly name: string;
  readonly label: string;
  readonly primary?: boolean;
}

/** The drop for another phone or computer, with the name that it was given. */
export function DropLink({ name, label, primary = false }: Props) {
  const [made, setMade] = useState<Made>();
  // An answer to other impacts or settings is another drop.
  const of = analysed.value;
  const { surface } = pupil();
  const make = (): Promise<void> =>
    linkOfDrop(name).then(
      (link) => setMade({ of, name, surface, link }),
      (error: unknown) => setMade({ of, name, surface, fault: faultOf(error) }),
    );
  const isOfThis = made?.of === of && made.name === name && made.surface === surface;
  const shown = isOfThis ? made : undefined;
  return (
    <>
      <button
        type="button"
        class={primary ? 'button primary' : 'quiet'}
        onClick={() => void make()}
      >
        {label}
      </button>
      <div role="status" class="stack">
        {shown?.link && <HandOver link={shown.link} label={text('page-keep-link-qr')} />}
      </div>
      {shown?.fault && <FaultNotice fault={shown.fault} />}
    </>
  );
}
