// The side panel: what colours tell, what is marked, what is missing, what is set.
import type { JSX } from "preact";
import { Marks } from "./marks";
import { Section } from "./section";
import { Settings } from "./settings";
import * as store from "./store";
import { isFigure, type Mode } from "./strands";
import type { Studio } from "./studio";
import { RAMP } from "./theme";
import type { Viewer } from "./viewer";

const MODES: Record<Mode, string> = {
  feature: "feature",
  time: "time laid",
  speed: "speed",
  slab: "slab",
  breach: "breach",
  sag: "forecast: sags",
  compliance: "forecast: gives way",
  flow: "forecast: flow",
  weld: "forecast: welds",
};

function css([r, g, b]: [number, number, number]): string {
  return `rgb(${r} ${g} ${b})`;
}

function Legend(): JSX.Element {
  const labels = (store.print.value?.labels ?? []).filter((label) => label.length_mm > 0);
  const flip = (name: string) => {
    const hidden = new Set(store.hidden.value);
    if (!hidden.delete(name)) hidden.add(name);
    store.hidden.value = hidden;
  };
  return (
    <ul class="legend">
      {labels.map((label) => (
        <li key={label.label}>
          <label>
            <input type="checkbox" checked={!store.hidden.value.has(label.label)} onChange={() => flip(label.label)} />
            <i style={{ background: css(label.colour) }} />
            <span>{label.name}</span>
            <small>{(label.length_mm / 1000).toFixed(2)} m</small>
          </label>
        </li>
      ))}
      {store.travelCount.value ? (
        <li>
          <label>
            <input
              type="checkbox"
              checked={store.showsTravels.value}
              onChange={() => (store.showsTravels.value = !store.showsTravels.value)}
            />
            <i class="travels" />
            <span>travel</span>
            <small>{store.travelCount.value.toLocaleString("en")}</small>
          </label>
        </li>
      ) : null}
    </ul>
  );
}

/** What strands would do, in colours and in words. */
function Foretold(): JSX.Element {
  const forecast = store.forecast.value;
  const mode = store.mode.value;
  const figure = isFigure(mode) ? forecast?.figures?.[mode] : undefined;
  if (!forecast) return <p class="quiet">Being forecast…</p>;
  if (forecast.error || !figure) return <p class="bad">{forecast.error}</p>;
  return (
    <>
      <div class="ramp">
        <i style={{ background: `linear-gradient(90deg, ${RAMP.map(css).join(", ")})` }} />
        <small>{`0 ${figure.unit}`}</small>
        <small>{`${figure.most} ${figure.unit} and more`}</small>
      </div>
      <p class="quiet">{`${figure.name}; ${forecast.trust}: a model, no part of the certificate. Grey: nothing is told.`}</p>
      <ul class="told">
        {(forecast.sentences ?? []).map((words) => (
          <li key={words}>{words}</li>
        ))}
      </ul>
    </>
  );
}

function Ramp(): JSX.Element {
  const [low, high] = store.range.value;
  const words = { time: store.instant, speed: (v: number) => `${v.toFixed(1)} mm/s`, slab: (v: number) => `${Math.round(v) + 1}` };
  const write = words[store.mode.value as "time" | "speed" | "slab"];
  return (
    <div class="ramp">
      <i style={{ background: `linear-gradient(90deg, ${RAMP.map(css).join(", ")})` }} />
      <small>{write(low)}</small>
      <small>{write(high)}</small>
    </div>
  );
}

/** Whether something is known by which to colour. */
function tells(mode: Mode): boolean {
  const print = store.print.value;
  if (!print || mode === "feature") return true;
  if (isFigure(mode)) return store.host.value !== "page";
  if (mode === "slab") return print.slabs_mm.length > 1;
  if (mode === "breach") return print.figures.certified !== undefined;
  return mode === "time" || print.timed;
}

/** Strands as they are commanded, or as the certificate says that they hang. */
function Relaxed(): JSX.Element | null {
  if (store.host.value === "page") return null;
  return (
    <label class="switch" title="A strand that hangs straightens to the chord between what holds it">
      <input type="checkbox" checked={store.relaxes.value} onChange={() => (store.relaxes.value = !store.relaxes.value)} />
      <span>strands relaxed to chords</span>
    </label>
  );
}

function Colours(): JSX.Element {
  const mode = store.mode.value;
  return (
    <Section name="Colour by">
      <select
        aria-label="colour by"
        value={mode}
        onChange={(event) => (store.mode.value = event.currentTarget.value as Mode)}
      >
        {Object.entries(MODES)
          .filter(([name]) => tells(name as Mode))
          .map(([name, words]) => (
            <option key={name} value={name}>
              {name === "feature" ? (store.print.value?.coloured_by ?? words) : words}
            </option>
          ))}
      </select>
      {mode === "feature" ? <Legend /> : mode === "breach" ? <p class="quiet">What breaks a rule is red.</p> : isFigure(mode) ? <Foretold /> : <Ramp />}
      <Relaxed />
    </Section>
  );
}

/** What is wrong or missing; each can be flown to. */
function Spots({ viewer }: { viewer: Viewer }): JSX.Element | null {
  const spots = store.spots.value;
  if (!spots.length)
    return store.print.value?.figures.certified ? (
      <p class="quiet">The G-code was judged move by move: nothing breaks a rule, nothing large is bare.</p>
    ) : null;
  return (
    <ul class="spots">
      {spots.map((spot, i) => (
        <li key={i} class={spot.kind}>
          {spot.at_mm ? (
            <button type="button" class="plain" onClick={() => viewer.flyTo(spot)}>
              {spot.words}
            </button>
          ) : (
            <span>{spot.words}</span>
          )}
          {spot.help ? <small>{spot.help}</small> : null}
        </li>
      ))}
    </ul>
  );
}

/** Amounts by name, of those that are known. */
function facts(): [string, string][] {
  const { figures, regions } = store.print.value ?? { figures: {}, regions: null };
  const { print_time_s: time, filament_mm: filament, filament_g: grams, filament_cost: cost } = figures;
  const off = store.rest.value?.deviation_mm;
  const laid = (store.print.value?.labels ?? []).reduce((sum, label) => sum + label.length_mm, 0);
  const found: [string, string][] = [];
  if (store.host.value === "page" && time !== undefined) found.push(["print time", store.clock(time)]);
  if (store.host.value === "page" && laid) found.push(["strands", `${(laid / 1000).toFixed(2)} m`]);
  if (filament !== undefined && grams !== undefined)
    {
    found.push(["filament", `${(filament / 1000).toFixed(2)} m · ${grams.toFixed(2)} g`]);
    // Nobody tells the currency: it is that of the price.
    if (cost) found.push(["costs", `${cost.toFixed(2)}, at ${Number(((1000 * cost) / grams).toPrecision(4))} a kilogram`]);
  }
  const hanging = store.rest.value?.chord_deviation_mm;
  if (off != null) found.push(["off the surface", `${off.toFixed(2)} mm on average`]);
  if (hanging != null) found.push(["relaxed", `${hanging.toFixed(2)} mm`]);
  if (regions) found.push(["in layers", `${(regions.area_mm2 / 100).toFixed(1)} cm²`]);
  if (figures.turn_to_fit_deg) found.push(["turned to fit", `${figures.turn_to_fit_deg.toFixed(1)}°`]);
  for (const { name, amount } of store.model.value?.shares ?? []) found.push([name, amount]);
  return found;
}

function Judged({ viewer }: { viewer: Viewer }): JSX.Element | null {
  const warnings = [...(store.print.value?.figures.warnings ?? []), ...(store.model.value?.repaired ?? [])];
  const known = facts();
  if (!known.length && !warnings.length && !store.spots.value.length) return null;
  return (
    <Section name={store.host.value === "page" ? "Totals" : "Verdict"}>
      <Spots viewer={viewer} />
      <dl class="facts">
        {known.map(([name, amount]) => (
          <>
            <dt>{name}</dt>
            <dd>{amount}</dd>
          </>
        ))}
      </dl>
      {warnings.length ? (
        <ul class="warnings">
          {warnings.map((words) => (
            <li key={words}>{words}</li>
          ))}
        </ul>
      ) : null}
    </Section>
  );
}

/** `studio` is null where nothing can be changed. */
export function Panel({ viewer, studio }: { viewer: Viewer; studio: Studio | null }): JSX.Element {
  return (
    <aside class={store.drawer.value ? "open" : ""} aria-label={studio ? "settings and marks" : "colours and figures"}>
      {studio || store.strandCount.value ? <Colours /> : null}
      {studio ? <Marks studio={studio} /> : null}
      <Judged viewer={viewer} />
      {studio ? <Settings studio={studio} /> : null}
    </aside>
  );
}
