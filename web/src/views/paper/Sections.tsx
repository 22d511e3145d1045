import { Figure, useAnswer } from '../../chart/Figure.tsx';
import { engine } from '../../state/engine.ts';
import { text } from '../../text/language.ts';

/** The charts of the lesson, computed by the engine. */
const useLesson = () => useAnswer(() => engine().lessonCharts(), 'lesson');

/** Flight times without air: a straight line, as the paper's Eq. 4 says. */
export function RulerFigure() {
  return <Figure chart={useLesson()?.[0]} see={text('page-paper-one-see')} />;
}

/** Drag over weight by both laws of the paper (its Figs. 6 and 7). */
export function DragFigure() {
  return <Figure chart={useLesson()?.[1]} see={text('page-paper-three-see')} />;
}

/** The whole drop with and without air (the paper's Fig. 8). */
export function HeightFigure() {
  return <Figure chart={useLesson()?.[2]} see={text('page-paper-three-see-height')} />;
}
