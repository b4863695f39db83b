// The list of marks, the shapes that can be added, and the brush.
import type { JSX } from "preact";
import { Icon } from "./icons";
import { Section } from "./section";
import { ShapeFields } from "./shapefields";
import type { Item } from "./protocol";
import * as store from "./store";
import type { Studio } from "./studio";

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

export function Marks({ studio }: { studio: Studio }): JSX.Element {
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
