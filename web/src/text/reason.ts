/** What exactly is wrong with a file or a link. */
import type { LabReason, LayoutProblem, TimesProblem } from '../lab/index.ts';
import { text, type Values } from './language.ts';

export function reasonText(reason: LabReason): string {
  switch (reason.code) {
    case 'empty':
      return text(`page-reason-empty-${reason.what}`);
    case 'not-sound':
      return text('page-reason-not-sound', { kind: text(`page-looks-${reason.looks_like}`) });
    case 'link':
      return text(`page-reason-link-${reason.problem}`);
    case 'unsupported-layout':
      return text(`page-reason-layout-${reason.problem.code}`, valuesOf(reason.problem));
    case 'times': {
      const problem = text(`page-reason-times-${reason.problem.code}`, valuesOf(reason.problem));
      return reason.line === null
        ? problem
        : text('page-reason-times-line', { line: reason.line, problem });
    }
    default:
      return text(`page-reason-${reason.code}`, valuesOf(reason));
  }
}

/** All but the code, as a message takes it. */
function valuesOf({ code, ...values }: LabReason | LayoutProblem | TimesProblem): Values {
  return Object.fromEntries(
    Object.entries(values).map(([name, value]) => [
      name,
      typeof value === 'number' ? value : String(value),
    ]),
  );
}
