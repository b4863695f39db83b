// The side panel: what colours tell, what is marked, the brush, what is missing.
import type { ComponentChildren, JSX } from "preact";
import { Icon } from "./icons";
import { ShapeFields } from "./shapefields";
import { Settings } from "./settings";
import type { Item } from "./protocol";
import * as store from "./store";
import type { Mode } from "./strands";
import type { Studio } from "./studio";
import { RAMP } from "./theme";

const MODES: Record<Mode, string> = {
  feature: "feature",
  time: "time laid",
  speed: "speed",
  slab: "slab",
  breach: "breach",
};

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
    </ul>
  );
}

function Ramp(): JSX.Element {
  const [low, high] = store.range.value;
  const words = { time: store.clock, speed: (v: number) => `${v.toFixed(1)} mm/s`, slab: (v: number) => `${Math.round(v) + 1}` };
  const write = words[store.mode.value as "time" | "speed" | "slab"];
  return (
    <div class="ramp">
      <i style={{ background: `linear-gradient(90deg, ${RAMP.map(css).join(", ")})` }} />
      <small>{write(low)}</small>
      <small>{write(high)}</small>
    </div>
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
        {Object.entries(MODES).map(([name, words]) => (
          <option key={name} value={name}>
            {words}
          </option>
        ))}
      </select>
      {mode === "feature" ? <Legend /> : mode === "breach" ? <p class="quiet">What breaks a rule is red.</p> : <Ramp />}
    </Section>
  );
}

function MarkLine({ item, place, last, studio }: {
  item: Item;
  place: number;
  last: number;
  studio: Studio;
}): JSX.Element {
  const { number } = item;
  const chosen = store.selected.value === number;
  const move = (to: number) => void studio.edit({ do: "move", number, to });
  return (
    <li class={`${item.on ? "" : "off"} ${chosen ? "chosen" : ""}`}>
      <div class="line">
        <button
          type="button"
          class="plain"
          aria-label={item.on ? `switch ${item.name} off` : `switch ${item.name} on`}
          onClick={() => void studio.edit({ do: "change", number, on: !item.on })}
        >
          <Icon name={item.on ? "eye" : "hide"} />
        </button>
        <i class={item.erase ? "erases" : "adds"} title={item.erase ? "printed as wire" : "printed as layers"} />
        <input
          class="name"
          aria-label={`name of ${item.name}`}
          value={item.name}
          maxLength={100}
          onFocus={() => (store.selected.value = number)}
          onChange={(event) => void studio.edit({ do: "change", number, name: event.currentTarget.value || item.name })}
        />
        <button type="button" class="plain" aria-label={`move ${item.name} up`} disabled={place === 0} onClick={() => move(place - 1)}>
          <Icon name="up" />
        </button>
        <button type="button" class="plain" aria-label={`move ${item.name} down`} disabled={place === last} onClick={() => move(place + 1)}>
          <Icon name="down" />
        </button>
        <button type="button" class="plain" aria-label={`delete ${item.name}`} onClick={() => void studio.edit({ do: "delete", number })}>
          <Icon name="trash" />
        </button>
      </div>
      {chosen ? <ShapeFields item={item} studio={studio} /> : null}
    </li>
  );
}

function Marks({ studio }: { studio: Studio }): JSX.Element {
  const items = store.state.value?.items ?? [];
  const add = (kind: "box" | "sphere" | "z" | "half", name: string) => (
    <button type="button" title={`add ${name}`} onClick={() => void studio.shape(kind)}>
      <Icon name={kind} /> {name}
    </button>
  );
  return (
    <Section name="Marks">
      {items.length ? (
        <ol class="marks">
          {items.map((item, i) => (
            <MarkLine key={item.number} item={item} place={i} last={items.length - 1} studio={studio} />
          ))}
        </ol>
      ) : (
        <p class="quiet">Nothing is marked: all is wire. Take the brush (B), or add a shape.</p>
      )}
      <div class="add" role="group" aria-label="add a shape">
        {add("box", "box")}
        {add("sphere", "ball")}
        {add("z", "heights")}
        {add("half", "half")}
      </div>
      <label class="slider">
        <span>brush</span>
        <input
          type="range"
          min={0.5}
          max={30}
          step={0.5}
          value={store.radiusMm.value}
          onInput={(event) => (store.radiusMm.value = event.currentTarget.valueAsNumber)}
        />
        <output>{store.radiusMm.value} mm</output>
      </label>
      <label class="slider" title="How far the surface may turn away from where the brush touches it">
        <span>spread</span>
        <input
          type="range"
          min={10}
          max={180}
          step={5}
          value={store.spreadDeg.value}
          onInput={(event) => (store.spreadDeg.value = event.currentTarget.valueAsNumber)}
        />
        <output>{store.spreadDeg.value}°</output>
      </label>
    </Section>
  );
}

function Judged({ studio }: { studio: Studio }): JSX.Element | null {
  const spots = store.spots.value;
  const figures = store.print.value?.figures;
  const warnings = [...(figures?.warnings ?? []), ...(store.model.value?.repaired ?? [])];
  const rest = store.rest.value;
  if (!figures) return null;
  return (
    <Section name="Verdict">
      {spots.length ? (
        <ul class="spots">
          {spots.map((spot, i) => (
            <li key={i} class={spot.kind}>
              {spot.at_mm ? (
                <button type="button" class="plain" onClick={() => studio.flyTo(spot)}>
                  {spot.words}
                </button>
              ) : (
                <span>{spot.words}</span>
              )}
              {spot.help ? <small>{spot.help}</small> : null}
            </li>
          ))}
        </ul>
      ) : (
        <p class="quiet">The G-code was judged move by move: nothing breaks a rule, nothing large is bare.</p>
      )}
      <dl class="facts">
        <dt>filament</dt>
        <dd>
          {(figures.filament_mm / 1000).toFixed(2)} m · {figures.filament_g.toFixed(2)} g
          {figures.filament_cost > 0 ? ` · ${figures.filament_cost.toFixed(2)}` : ""}
        </dd>
        {rest?.deviation_mm != null ? (
          <>
            <dt>off the surface</dt>
            <dd>{rest.deviation_mm.toFixed(2)} mm on average</dd>
          </>
        ) : null}
        {store.print.value?.regions ? (
          <>
            <dt>in layers</dt>
            <dd>{(store.print.value.regions.area_mm2 / 100).toFixed(1)} cm²</dd>
          </>
        ) : null}
        {figures.turn_to_fit_deg ? (
          <>
            <dt>turned to fit</dt>
            <dd>{figures.turn_to_fit_deg.toFixed(1)}°</dd>
          </>
        ) : null}
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

export function Panel({ studio }: { studio: Studio }): JSX.Element {
  return (
    <aside class={store.drawer.value ? "open" : ""} aria-label="settings and marks">
      <Colours />
      <Marks studio={studio} />
      <Judged studio={studio} />
      <Settings studio={studio} />
    </aside>
  );
}
