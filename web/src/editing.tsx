// What changes a print, around the picture: profiles, files, tools.
import type { JSX } from "preact";
import { Icon } from "./icons";
import * as store from "./store";
import type { Studio } from "./studio";

export function Profile({ kind, studio }: { kind: "printer" | "material"; studio: Studio }): JSX.Element {
  const names = (kind === "printer" ? store.welcome.value?.printers : store.welcome.value?.materials) ?? [];
  const now = store.state.value?.[kind] ?? "";
  return (
    <select
      aria-label={kind}
      value={now}
      disabled={!store.state.value}
      onChange={(event) => void studio.edit({ do: "profile", [kind]: event.currentTarget.value })}
    >
      {(names.includes(now) ? names : [now, ...names]).map((name) => (
        <option key={name} value={name}>
          {name}
        </option>
      ))}
    </select>
  );
}

export function ExportMenu({ studio }: { studio: Studio }): JSX.Element {
  const ready = store.print.value !== null;
  const close = (event: Event) => (event.currentTarget as HTMLElement).closest("details")?.removeAttribute("open");
  const entry = (words: string, key: string, act: () => void) => (
    <button
      type="button"
      role="menuitem"
      onClick={(event) => {
        close(event);
        act();
      }}
    >
      {words} <kbd>{key}</kbd>
    </button>
  );
  return (
    <div class="export">
      <button type="button" class="primary" disabled={!ready} onClick={() => void studio.export("gcode")}>
        Export G-code
      </button>
      <details
        onFocusOut={(event) => {
          if (!event.currentTarget.contains(event.relatedTarget as Node | null)) event.currentTarget.open = false;
        }}
        onKeyDown={(event) => {
          if (event.key !== "Escape" || !event.currentTarget.open) return;
          event.stopPropagation();
          event.currentTarget.open = false;
          event.currentTarget.querySelector("summary")?.focus();
        }}
      >
        <summary class="primary" aria-label="more to export">
          <Icon name="down" />
        </summary>
        <div class="menu" role="menu">
          {entry("G-code", "Ctrl E", () => void studio.export("gcode"))}
          {entry("Project (3MF)", "Ctrl S", () => void studio.export("project"))}
          {entry("Strokes (JSON)", "", () => void studio.export("strokes"))}
          {entry("Picture (PNG)", "", () => void studio.picture())}
          <hr />
          {entry("Send to a printer…", "", () => (store.dialog.value = "send"))}
          {store.welcome.value?.saves ? (
            <>
              <hr />
              <small>beside the model</small>
              {entry("Save G-code", "", () => void studio.save("gcode"))}
              {entry("Save project", "", () => void studio.save("project"))}
              {entry("Save strokes", "", () => void studio.save("strokes"))}
            </>
          ) : null}
        </div>
      </details>
    </div>
  );
}

function Tool({ icon, name, keyName, on, off, act }: {
  icon: string;
  name: string;
  keyName: string;
  on?: boolean;
  off?: boolean;
  act: () => void;
}): JSX.Element {
  return (
    <button
      type="button"
      class="tool"
      aria-label={name}
      title={`${name} (${keyName})`}
      aria-pressed={on}
      disabled={off}
      onClick={act}
    >
      <Icon name={icon} />
    </button>
  );
}

function Edits({ studio }: { studio: Studio }): JSX.Element {
  const tool = store.tool.value;
  const flat = !store.turns.value;
  return (
    <>
      <Tool icon="turn" name="Turn" keyName="V" on={tool === "turn"} act={() => (store.tool.value = "turn")} />
      <Tool icon="fill" name="Print as layers" keyName="B" on={tool === "fill"} off={flat} act={() => (store.tool.value = "fill")} />
      <Tool icon="erase" name="Print as wire" keyName="E" on={tool === "erase"} off={flat} act={() => (store.tool.value = "erase")} />
      <hr />
      <Tool icon="undo" name="Undo" keyName="Ctrl Z" off={!store.state.value?.can_undo} act={() => void studio.edit({ do: "undo" })} />
      <Tool icon="redo" name="Redo" keyName="Ctrl Shift Z" off={!store.state.value?.can_redo} act={() => void studio.edit({ do: "redo" })} />
      <hr />
    </>
  );
}

/** `studio` is null where nothing can be changed. */
export function Tools({ studio }: { studio: Studio | null }): JSX.Element {
  return (
    <nav class="tools" aria-label="tools">
      {studio ? <Edits studio={studio} /> : null}
      {studio || store.model.value ? (
        <Tool icon="model" name="Model" keyName="M" on={store.showsModel.value} act={() => (store.showsModel.value = !store.showsModel.value)} />
      ) : null}
      {studio || store.strandCount.value ? (
        <Tool icon="wire" name="Wire" keyName="W" on={store.showsWire.value} act={() => (store.showsWire.value = !store.showsWire.value)} />
      ) : null}
      <span class="grow" />
      <Tool icon="key" name="Keys" keyName="?" act={() => (store.dialog.value = "keys")} />
    </nav>
  );
}
