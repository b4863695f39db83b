// What stands around the picture in every host: the head with its figures, the timeline, the slabs.
import type { JSX } from "preact";
import { ExportMenu, Profile } from "./editing";
import { Icon } from "./icons";
import type { Studio } from "./studio";
import * as store from "./store";
import { clock, instant } from "./store";
import { VIEWS, type ViewName } from "./view";
import type { Viewer } from "./viewer";

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

/** Amounts that are known; of a print that is awaited, dashes. */
function Figures(): JSX.Element | null {
  const awaited = store.print.value === null;
  const { print_time_s: time, filament_g: grams, coverage, certified } = store.print.value?.figures ?? {};
  if (awaited && store.host.value === "page") return null;
  const shown = (name: string, value: number | undefined, write: (value: number) => string) =>
    value !== undefined || awaited ? <Figure name={name} value={value === undefined ? "–" : write(value)} /> : null;
  const [words, tone] = verdict();
  return (
    <dl class={`figures ${store.outOfDate.value ? "stale" : ""}`} aria-live="polite" aria-label="print">
      {shown("print time", time, clock)}
      {shown("filament", grams, (value) => `${value.toFixed(1)} g`)}
      {shown("coverage", coverage, (value) => `${(100 * value).toFixed(1)} %`)}
      {certified !== undefined || awaited ? <Figure name="certificate" value={words} tone={tone} /> : null}
    </dl>
  );
}

/** What is shown, in a few words. */
function about(): string {
  const model = store.model.value;
  if (model) {
    const size = model.size_mm.map((mm) => mm.toFixed(0)).join(" × ");
    return `${size} mm · ${model.triangles.toLocaleString("en")} triangles`;
  }
  const size = store.welcome.value?.size_mm?.map((mm) => mm.toFixed(1)).join(" × ");
  return size ? `${size} mm` : "is being read";
}

/** `studio` is null where nothing can be changed. */
export function Head({ studio }: { studio: Studio | null }): JSX.Element {
  const name = store.model.value?.name ?? store.welcome.value?.name ?? "…";
  return (
    <header>
      <div class="title">
        <h1>wireprint</h1>
        <div class="model">
          <b title={name}>{name}</b>
          <small>{about()}</small>
        </div>
      </div>
      {studio ? (
        <div class="profiles">
          <Profile kind="printer" studio={studio} />
          <Profile kind="material" studio={studio} />
        </div>
      ) : null}
      <Figures />
      {studio ? <ExportMenu studio={studio} /> : null}
      <button
        type="button"
        class="plain drawer"
        aria-label={studio ? "settings and marks" : "colours and figures"}
        aria-expanded={store.drawer.value}
        onClick={() => (store.drawer.value = !store.drawer.value)}
      >
        <Icon name="panel" />
      </button>
    </header>
  );
}

export function Views({ viewer }: { viewer: Viewer }): JSX.Element {
  return (
    <div class="views" role="group" aria-label="views">
      {(Object.keys(VIEWS) as ViewName[]).map((name) => (
        <button type="button" key={name} onClick={() => viewer.view.look(name)}>
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
  const print = store.print.value?.labels.length ? store.print.value : null;
  const until = store.shownStrands.value;
  const all = store.strandCount.value;
  return (
    <>
      <p class="hint">{hints[store.tool.value]}</p>
      <p class="count">
        {store.outOfDate.value ? <span class="stale-word">out of date</span> : null}
        {print ? `${until < all ? `${until.toLocaleString("en")} of ` : ""}${all.toLocaleString("en")} strands` : ""}
        {print && print.made_s !== null ? ` · ${Math.round(1000 * print.made_s)} ms` : ""}
        {store.progress.value ? ` · ${store.progress.value}` : ""}
      </p>
    </>
  );
}

export function Timeline({ viewer }: { viewer: Viewer }): JSX.Element | null {
  const total = store.totalS.value;
  const time = Math.min(store.timeS.value, total);
  if (!total && store.host.value === "page") return null;
  return (
    <footer>
      <button
        type="button"
        class="plain"
        aria-label={store.playing.value ? "pause" : "play"}
        disabled={total === 0}
        onClick={() => viewer.play()}
      >
        <Icon name={store.playing.value ? "pause" : "play"} />
      </button>
      <input
        type="range"
        class="time"
        aria-label="time shown"
        aria-valuetext={`${instant(time)} of ${instant(total)}`}
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
        {instant(time)} / {instant(total)}
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
      {store.turns.value ? null : (
        <p class="fair">
          This browser has no WebGL 2, or has it switched off: pictures are shown in its place, and nothing can be painted.
        </p>
      )}
      {store.linked.value || !store.welcome.value ? null : (
        <p class="bad">The session is gone; start wireprint studio again. What you see stays.</p>
      )}
      {store.failure.value ? <p class="bad">{store.failure.value}</p> : null}
      {store.notice.value ? <p class="fair">{store.notice.value}</p> : null}
      {toast ? <p class={toast.bad ? "bad" : ""}>{toast.words}</p> : null}
    </div>
  );
}

/** A picture in place of a canvas that cannot be drawn on. */
export function Still(): JSX.Element | null {
  const { value: still } = store.still;
  return still && !store.turns.value ? <img class="still" src={still} alt="model and print" /> : null;
}
