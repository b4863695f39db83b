// Every setting, made from the schema: unit, bounds, help, search, and what differs from the profile.
import { useSignal } from "@preact/signals";
import type { JSX } from "preact";
import { Icon } from "./icons";
import type { Field, Value } from "./protocol";
import * as store from "./store";
import type { Studio } from "./studio";

/** Sections that are open before anything is searched. */
const OPEN = new Set(["wire"]);

function matches(field: Field, words: string[]): boolean {
  const text = `${field.key} ${field.name} ${field.help} ${store.sections.value[field.section] ?? ""}`.toLowerCase();
  return words.every((word) => text.includes(word));
}

function bounds({ low, high, unit }: Field): string {
  if (low === null && high === null) return "";
  const from = low === null ? "" : `${low}`;
  const to = high === null ? "" : `${high}`;
  return `${from}–${to}${unit ? ` ${unit}` : ""}`;
}

/** "None" is how Python says that a field is left to itself; people read "auto". */
function help(field: Field): string {
  return field.help.replace(/\bNone( or auto)?\b/g, "auto");
}

function Control({ field, value, studio }: { field: Field; value: Value; studio: Studio }): JSX.Element {
  const { key, kind } = field;
  const id = `set-${key}`;
  const about = `${id}-about`;
  const common = {
    id,
    "aria-describedby": about,
    "aria-invalid": store.refusals.value[key] !== undefined,
  };
  if (kind === "switch")
    return <input {...common} type="checkbox" checked={value === true} onChange={(event) => void studio.set(key, event.currentTarget.checked)} />;
  if (kind === "choice")
    return (
      <select {...common} value={String(value)} onChange={(event) => void studio.set(key, event.currentTarget.value)}>
        {field.choices.map((choice) => (
          <option key={choice} value={choice}>
            {choice}
          </option>
        ))}
      </select>
    );
  if (kind === "text")
    return (
      <textarea
        {...common}
        rows={String(value).includes("\n") ? 4 : 1}
        spellcheck={false}
        value={String(value ?? "")}
        onChange={(event) => void studio.set(key, event.currentTarget.value)}
      />
    );
  const automatic = store.state.value?.automatic[key];
  // A word that stands for an amount is what an empty field means.
  const word = field.choices[0];
  return (
    <input
      {...common}
      type="number"
      step={kind === "integer" ? 1 : "any"}
      value={value === null || value === word ? "" : String(value)}
      placeholder={word ?? (automatic === undefined ? "auto" : `auto ${automatic}`)}
      onChange={(event) => {
        const text = event.currentTarget.value;
        void studio.set(key, text === "" ? (word ?? null) : Number(text));
      }}
    />
  );
}

function Line({ field, studio }: { field: Field; studio: Studio }): JSX.Element {
  const { key } = field;
  const value = store.state.value?.settings[key] ?? null;
  const differs = key in (store.state.value?.differs ?? {});
  const refused = store.refusals.value[key];
  const range = bounds(field);
  return (
    <div class={`setting ${differs ? "differs" : ""}`}>
      <label for={`set-${key}`}>{field.name}</label>
      <div class="control">
        <Control field={field} value={value} studio={studio} />
        <span class="unit">{field.unit}</span>
        {differs ? (
          <button type="button" class="plain" aria-label={`take the profile's ${field.name}`} title={`the profile's: ${String(store.state.value?.differs[key])}`} onClick={() => void studio.set(key, null)}>
            <Icon name="back" />
          </button>
        ) : null}
      </div>
      <small id={`set-${key}-about`} class={refused ? "refused" : ""}>
        {refused ?? [help(field), range].filter(Boolean).join(" · ")}
      </small>
    </div>
  );
}

export function Settings({ studio }: { studio: Studio }): JSX.Element {
  const search = useSignal("");
  const only = useSignal(false);
  const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
  const differs = store.state.value?.differs ?? {};
  const found = store.fields.value.filter((field) => matches(field, words) && (!only.value || field.key in differs));
  const count = Object.keys(differs).length;
  return (
    <section class="settings">
      <h2>Settings</h2>
      <div class="search">
        <input
          type="search"
          placeholder={`search ${store.fields.value.length} settings`}
          aria-label="search settings"
          value={search.value}
          onInput={(event) => (search.value = event.currentTarget.value)}
        />
        <label>
          <input type="checkbox" checked={only.value} onChange={() => (only.value = !only.value)} />
          <span>{count ? `${count} changed` : "changed"}</span>
        </label>
      </div>
      {Object.entries(store.sections.value).map(([section, name]) => {
        const lines = found.filter((field) => field.section === section);
        if (!lines.length) return null;
        const asked = words.length > 0 || only.value;
        return (
          <details class="section" key={`${section} ${asked}`} open={asked || OPEN.has(section)}>
            <summary>
              <h3>{name}</h3>
            </summary>
            {lines.map((field) => (
              <Line key={field.key} field={field} studio={studio} />
            ))}
          </details>
        );
      })}
      {store.fields.value.length && !found.length ? <p class="quiet">No setting is like that.</p> : null}
    </section>
  );
}
