// What stands around the picture: the head with its figures, the tools, the timeline, the slabs.
import type { JSX } from "preact";
import { Icon } from "./icons";
import type { Studio } from "./studio";
import * as store from "./store";
import { clock } from "./store";
import { VIEWS, type ViewName } from "./view";

function Figure({ name, value, tone }: { name: string; value: string; tone?: string }): JSX.Element {
  return (
    <div class="figure">
      <dt>{name}</dt>
      <dd class={tone ?? ""}>{value}</dd>
    </div>
  );
}

function verdict(): [string, string] {
  const found = store.print.value;
  if (store.failure.value) return ["cannot be printed", "bad"];
  if (!found) return ["…", ""];
  const count = found.breaches.length;
  if (!found.figures.certified) return [count ? `${count} breach${count === 1 ? "" : "es"}` : "not judged", "bad"];
  return found.figures.whole ? ["keeps all rules", "good"] : ["much left bare", "fair"];
}

function Figures(): JSX.Element {
  const figures = store.print.value?.figures;
  const [words, tone] = verdict();
  return (
    <dl class={`figures ${store.outOfDate.value ? "stale" : ""}`} aria-live="polite" aria-label="print">
      <Figure name="print time" value={figures ? clock(figures.print_time_s) : "–"} />
      <Figure name="filament" value={figures ? `${figures.filament_g.toFixed(1)} g` : "–"} />
      <Figure name="coverage" value={figures ? `${(100 * figures.coverage).toFixed(1)} %` : "–"} />
      <Figure name="certificate" value={words} tone={tone} />
    </dl>
  );
}

function Profile({ kind, studio }: { kind: "printer" | "material"; studio: Studio }): JSX.Element {
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

function ExportMenu({ studio }: { studio: Studio }): JSX.Element {
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
      >
        <summary class="primary" aria-label="more to export">
          <Icon name="down" />
        </summary>
        <div class="menu" role="menu">
          {entry("G-code", "Ctrl E", () => void studio.export("gcode"))}
          {entry("Project (3MF)", "Ctrl S", () => void studio.export("project"))}
          {entry("Strokes (JSON)", "", () => void studio.export("strokes"))}
          {entry("Picture (PNG)", "", () => void studio.picture())}
        </div>
      </details>
    </div>
  );
}

export function Head({ studio }: { studio: Studio }): JSX.Element {
  const model = store.model.value;
  const size = model?.size_mm.map((mm) => mm.toFixed(0)).join(" × ");
  return (
    <header>
      <div class="title">
        <h1>wireprint</h1>
        <div class="model">
          <b title={model?.name}>{model?.name ?? store.welcome.value?.name ?? "…"}</b>
          <small>{model ? `${size} mm · ${model.triangles.toLocaleString("en")} triangles` : "is being read"}</small>
        </div>
      </div>
      <div class="profiles">
        <Profile kind="printer" studio={studio} />
        <Profile kind="material" studio={studio} />
      </div>
      <Figures />
      <ExportMenu studio={studio} />
      <button
        type="button"
        class="plain drawer"
        aria-label="settings and marks"
        aria-expanded={store.drawer.value}
        onClick={() => (store.drawer.value = !store.drawer.value)}
      >
        <Icon name="panel" />
      </button>
    </header>
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

export function Tools({ studio }: { studio: Studio }): JSX.Element {
  const tool = store.tool.value;
  return (
    <nav class="tools" aria-label="tools">
      <Tool icon="turn" name="Turn" keyName="V" on={tool === "turn"} act={() => (store.tool.value = "turn")} />
      <Tool icon="fill" name="Print as layers" keyName="B" on={tool === "fill"} act={() => (store.tool.value = "fill")} />
      <Tool icon="erase" name="Print as wire" keyName="E" on={tool === "erase"} act={() => (store.tool.value = "erase")} />
      <hr />
      <Tool icon="undo" name="Undo" keyName="Ctrl Z" off={!store.state.value?.can_undo} act={() => void studio.edit({ do: "undo" })} />
      <Tool icon="redo" name="Redo" keyName="Ctrl Shift Z" off={!store.state.value?.can_redo} act={() => void studio.edit({ do: "redo" })} />
      <hr />
      <Tool icon="model" name="Model" keyName="M" on={store.showsModel.value} act={() => (store.showsModel.value = !store.showsModel.value)} />
      <Tool icon="wire" name="Wire" keyName="W" on={store.showsWire.value} act={() => (store.showsWire.value = !store.showsWire.value)} />
      <span class="grow" />
      <Tool icon="key" name="Keys" keyName="?" act={() => (store.helps.value = true)} />
    </nav>
  );
}

export function Views({ studio }: { studio: Studio }): JSX.Element {
  return (
    <div class="views" role="group" aria-label="views">
      {(Object.keys(VIEWS) as ViewName[]).map((name) => (
        <button type="button" key={name} onClick={() => studio.view.look(name)}>
          {name}
        </button>
      ))}
    </div>
  );
}

export function Slabs(): JSX.Element | null {
  const print = store.print.value;
  const last = print ? print.slabs_mm.length - 1 : 0;
  if (!print || last < 1) return null;
  const slab = Math.min(store.slab.value, last);
  return (
    <div class="slabs">
      <output>{`${print.slabs_mm[slab]!.toFixed(1)} mm`}</output>
      <input
        type="range"
        aria-label="slabs shown"
        aria-valuetext={`${slab + 1} of ${last + 1} slabs, up to ${print.slabs_mm[slab]!.toFixed(1)} mm`}
        min={0}
        max={last}
        value={slab}
        onInput={(event) => {
          const to = event.currentTarget.valueAsNumber;
          store.slab.value = to >= last ? Infinity : to;
        }}
      />
    </div>
  );
}

export function Hints(): JSX.Element {
  const hints = {
    turn: "Drag: turn · right or two fingers: move · wheel: zoom",
    fill: "Drag on the model: print as layers · Alt or beside it: turn · [ ] size",
    erase: "Drag on the model: print as wire · Alt or beside it: turn · [ ] size",
  };
  const print = store.print.value;
  const until = store.shownStrands.value;
  const all = store.strandCount.value;
  return (
    <>
      <p class="hint">{hints[store.tool.value]}</p>
      <p class="count">
        {store.outOfDate.value ? <span class="stale-word">out of date</span> : null}
        {print ? `${until < all ? `${until.toLocaleString("en")} of ` : ""}${all.toLocaleString("en")} strands · ${Math.round(1000 * print.made_s)} ms` : ""}
      </p>
    </>
  );
}

export function Timeline({ studio }: { studio: Studio }): JSX.Element {
  const total = store.totalS.value;
  const time = Math.min(store.timeS.value, total);
  return (
    <footer>
      <button
        type="button"
        class="plain"
        aria-label={store.playing.value ? "pause" : "play"}
        disabled={total === 0}
        onClick={() => studio.play()}
      >
        <Icon name={store.playing.value ? "pause" : "play"} />
      </button>
      <input
        type="range"
        class="time"
        aria-label="time shown"
        aria-valuetext={`${clock(time)} of ${clock(total)}`}
        min={0}
        max={total || 1}
        step="any"
        value={total ? time : 1}
        disabled={total === 0}
        style={{ "--share": total ? time / total : 1 }}
        onInput={(event) => {
          const to = event.currentTarget.valueAsNumber;
          store.playing.value = false;
          store.timeS.value = to >= total ? Infinity : to;
        }}
      />
      <output class="clock">
        {clock(time)} / {clock(total)}
      </output>
      <select
        aria-label="speed of playing"
        value={store.rate.value}
        onChange={(event) => (store.rate.value = Number(event.currentTarget.value))}
      >
        {[1, 10, 60, 300].map((rate) => (
          <option key={rate} value={rate}>{`${rate}×`}</option>
        ))}
      </select>
    </footer>
  );
}

export function Messages(): JSX.Element {
  const { value: toast } = store.toast;
  return (
    <div class="messages" role="status">
      {store.linked.value || !store.welcome.value ? null : (
        <p class="bad">The session is gone; start wireprint studio again. What you see stays.</p>
      )}
      {store.failure.value ? <p class="bad">{store.failure.value}</p> : null}
      {store.notice.value ? <p class="fair">{store.notice.value}</p> : null}
      {toast ? <p class={toast.bad ? "bad" : ""}>{toast.words}</p> : null}
    </div>
  );
}
