import { text } from '../text/language.ts';

/** Ends what takes long. */
export function Cancel({ onCancel }: { readonly onCancel: () => void }) {
  return (
    <div class="row">
      <button type="button" class="quiet" onClick={onCancel}>
        {text('page-app-cancel')}
      </button>
    </div>
  );
}
