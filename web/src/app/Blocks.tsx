import { type ComponentChildren, Fragment } from 'preact';
import { Figure } from '../chart/Figure.tsx';
import type { Block, Section, Table } from '../lab/index.ts';
import { text } from '../text/language.ts';
import { saveText } from './save.ts';

interface ReportedProps {
  readonly lead: readonly Block[];
  readonly sections: readonly Section[];
  /** What the button says that saves the report, and as which file. */
  readonly label: string;
  readonly name: string;
  report(made: string): Promise<string>;
  /** What else belongs to the details. */
  readonly children?: ComponentChildren;
}

/** The beginning of a report, the whole as a file, and its details, folded. */
export function Reported({ lead, sections, label, name, report, children }: ReportedProps) {
  const save = async (): Promise<void> =>
    saveText(await report(new Date().toISOString().slice(0, 10)), 'text/html', `${name}.html`);
  return (
    <>
      <Blocks blocks={lead} />
      <div>
        <button type="button" class="quiet no-print" onClick={() => void save()}>
          {label}
        </button>
      </div>
      <details>
        <summary>{text('page-class-details')}</summary>
        <Sections sections={sections} />
        {children}
      </details>
    </>
  );
}

/** What a report says, as part of the page; what is words only is folded. */
function Sections({ sections }: { readonly sections: readonly Section[] }) {
  return (
    <>
      {sections.map(({ heading, blocks }) =>
        blocks.some((block) => !('Text' in block)) ? (
          <section key={heading} class="stack wide" aria-label={heading}>
            <h3>{heading}</h3>
            <Blocks blocks={blocks} />
          </section>
        ) : (
          <details key={heading}>
            <summary>{heading}</summary>
            <Blocks blocks={blocks} />
          </details>
        ),
      )}
    </>
  );
}

function Blocks({ blocks }: { readonly blocks: readonly Block[] }) {
  return (
    <>
      {blocks.map((block, index) => (
        <One key={index} block={block} />
      ))}
    </>
  );
}

function One({ block }: { readonly block: Block }) {
  if ('Lead' in block) return <p class="lead">{block.Lead}</p>;
  if ('Text' in block) return <p>{block.Text}</p>;
  if ('Note' in block) return <p class="notice">{block.Note}</p>;
  if ('Table' in block) return <OneTable {...block.Table} />;
  if ('Facts' in block) {
    return (
      <dl class="facts">
        {block.Facts.map(([name, value]) => (
          <Fragment key={name}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </Fragment>
        ))}
      </dl>
    );
  }
  if ('Figure' in block) return <Figure chart={block.Figure.chart} />;
  if ('List' in block) {
    return (
      <ul>
        {block.List.map((item) => (
          <li key={item}>{item}</li>
        ))}
      </ul>
    );
  }
  return null;
}

function OneTable({ caption, table }: { readonly caption: string; readonly table: Table }) {
  const side = (column: number) => (table.align[column] === 'Right' ? 'figure' : undefined);
  return (
    <section class="scroll" tabIndex={0} aria-label={caption}>
      <table>
        <caption>{caption}</caption>
        <thead>
          <tr>
            {table.header.map((name, column) =>
              name === '' ? (
                <td key={column} />
              ) : (
                <th key={column} class={side(column)}>
                  {name}
                </th>
              ),
            )}
          </tr>
        </thead>
        <tbody>
          {table.rows.map((row, place) => (
            <tr key={place}>
              {row.map((cell, column) => (
                <td key={column} class={side(column)}>
                  {cell}
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}
