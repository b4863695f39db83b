// A part of the side panel that folds.
import type { ComponentChildren, JSX } from "preact";

export function Section({ name, open = true, children }: {
  name: string;
  open?: boolean;
  children: ComponentChildren;
}): JSX.Element {
  return (
    <details class="section" open={open}>
      <summary>
        <h2>{name}</h2>
      </summary>
      {children}
    </details>
  );
}
