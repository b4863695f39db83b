// Something that is answered or closed before all else goes on.
import { useLayoutEffect, useRef } from "preact/hooks";
import type { ComponentChildren, JSX } from "preact";
import { Icon } from "./icons";

/** The browser's own modal: it keeps the focus, closes with Escape, and gives the focus back. */
export function Dialog({ name, onClose, children }: {
  name: string;
  onClose: () => void;
  children: ComponentChildren;
}): JSX.Element {
  const frame = useRef<HTMLDialogElement>(null);
  useLayoutEffect(() => {
    if (!frame.current!.open) frame.current!.showModal();
  }, []);
  return (
    <dialog
      ref={frame}
      aria-label={name}
      onClose={onClose}
      onClick={(event) => {
        if (event.target === event.currentTarget) event.currentTarget.close();
      }}
    >
      <div class="leaf">
        <h2>{name}</h2>
        <button type="button" class="plain close" aria-label="close" onClick={() => frame.current!.close()}>
          <Icon name="close" />
        </button>
        {children}
      </div>
    </dialog>
  );
}
