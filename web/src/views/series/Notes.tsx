import { useState } from 'preact/hooks';
import { NumberField } from '../../app/NumberField.tsx';
import { ABSOLUTE_ZERO_C, scaled } from '../../format/quantity.ts';
import type { JobShown, Settings } from '../../lab/index.ts';
import { state } from '../../state/series.ts';
import { withChanges } from '../../state/settings.ts';
import { busy } from '../../state/workspace.ts';
import { text } from '../../text/language.ts';
import { Kept } from '../verdict/Kept.tsx';
import { Field } from './Field.tsx';

/** What a person states of a test: what its report shows, what was kept, and what was measured. */
export function Notes({ shown }: { readonly shown: JobShown }) {
  /** What was changed here and is not kept yet. */
  const [changed, setChanged] = useState<Changes>(NOTHING);
  const { fields, kept = shown.kept, settings = shown.settings } = changed;
  return (
    <details class="notes">
      <summary>{text('page-series-notes')}</summary>
      <form
        class="stack"
        onSubmit={(event) => {
          event.preventDefault();
          if (busy.peek()) return;
          void state(fields, kept, settings).then((isDone) => isDone && setChanged(NOTHING));
        }}
      >
        <Measured
          settings={settings}
          onChange={(measured) => setChanged({ ...changed, settings: measured })}
        />
        <Kept
          parts={shown.judged?.stated ?? []}
          kept={kept}
          onChange={(parts) => setChanged({ ...changed, kept: parts })}
        />
        <div class="measures">
          {shown.fields.map(({ name, label, value, is_list }) => (
            <Field
              key={name}
              label={label}
              value={fields[name] ?? value}
              isLong={is_list}
              onChange={(typed) => setChanged({ ...changed, fields: { ...fields, [name]: typed } })}
            />
          ))}
        </div>
        <div>
          <button type="submit" class="button" disabled={changed === NOTHING || busy.value}>
            {text('page-series-notes-keep')}
          </button>
        </div>
      </form>
    </details>
  );
}

interface Changes {
  readonly fields: Readonly<Record<string, string>>;
  readonly kept?: readonly string[];
  readonly settings?: Settings;
}
const NOTHING: Changes = { fields: {} };

interface MeasuredProps {
  readonly settings: Settings;
  readonly onChange: (settings: Settings) => void;
}

/** What was measured: it counts in place of what is assumed. */
function Measured({ settings, onChange }: MeasuredProps) {
  const { height_m, height_sd_m } = settings.drop ?? {};
  const { temperature_k, relative_humidity } = settings.air ?? {};
  return (
    <div class="measures">
      <NumberField
        label={text('page-settings-height')}
        unit="cm"
        min={0.1}
        value={scaled(height_m, 100)}
        onChange={(cm) => onChange(withChanges(settings, 'drop', { height_m: scaled(cm, 0.01) }))}
      />
      <NumberField
        label={text('page-settings-height-sd')}
        unit="mm"
        min={0.01}
        value={scaled(height_sd_m, 1e3)}
        onChange={(mm) =>
          onChange(withChanges(settings, 'drop', { height_sd_m: scaled(mm, 1e-3) }))
        }
      />
      <NumberField
        label={text('page-settings-temperature')}
        unit="°C"
        min={-60}
        max={60}
        value={scaled(temperature_k, 1, ABSOLUTE_ZERO_C)}
        onChange={(celsius) =>
          onChange(
            withChanges(settings, 'air', {
              temperature_k: celsius === undefined ? undefined : celsius - ABSOLUTE_ZERO_C,
            }),
          )
        }
      />
      <NumberField
        label={text('page-settings-humidity')}
        unit="%"
        min={0}
        max={100}
        value={scaled(relative_humidity, 100)}
        onChange={(percent) =>
          onChange(withChanges(settings, 'air', { relative_humidity: scaled(percent, 0.01) }))
        }
      />
    </div>
  );
}
