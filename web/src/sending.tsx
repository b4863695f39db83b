// Sending to the user's hosts: which, what is on its way, and a second question before anything is printed.
import { useSignal } from "@preact/signals";
import type { JSX } from "preact";
import { Dialog } from "./dialog";
import type { Asked } from "./protocol";
import * as store from "./store";
import type { Studio } from "./studio";

/** What one looks at before a file goes to a printer. */
function About({ file }: { file?: string }): JSX.Element {
  const { print_time_s: time, filament_g: grams, certified, whole } = store.print.value?.figures ?? {};
  const rows: [string, string][] = [
    ...(file ? ([["file", file]] as [string, string][]) : []),
    ["made for", `${store.state.value?.printer ?? "…"}, ${store.state.value?.material ?? "…"}`],
    ["print time", time === undefined ? "–" : store.clock(time)],
    ["filament", grams === undefined ? "–" : `${grams.toFixed(1)} g`],
    ["certificate", !certified ? "breaks rules" : whole ? "keeps all rules" : "keeps all rules, much left bare"],
  ];
  return (
    <dl class="facts">
      {rows.map(([name, amount]) => (
        <>
          <dt>{name}</dt>
          <dd>{amount}</dd>
        </>
      ))}
    </dl>
  );
}

/** What became of the file that was sent last. */
function Under(): JSX.Element | null {
  const sending = store.sending.value;
  if (!sending) return null;
  const { share } = sending;
  return (
    <div class="sending" role="status">
      <p class={sending.error ? "bad" : ""}>{store.sendingWords(sending)}</p>
      {share === null ? null : <progress aria-label="sent" max={1} {...(share < 1 ? { value: share } : {})} />}
    </div>
  );
}

function NoHosts({ fault, file }: { fault: string; file: string }): JSX.Element {
  if (fault) return <p class="bad">{fault}</p>;
  return (
    <div class="nohosts">
      <p>No host is known yet. Write one into this file, and keep it to yourself (chmod 600):</p>
      <code>{file}</code>
      <pre>{'[workshop]\nkind = "octoprint"  # or moonraker, prusalink, duet\nurl = "http://octopi.local"\nkey = "…"'}</pre>
      <p class="quiet">Keys stay in that file; this page is told the names alone. Reload the page once it is written.</p>
    </div>
  );
}

export function Sending({ studio }: { studio: Studio }): JSX.Element {
  const { hosts = [], hosts_fault: fault = "", hosts_file: file = "" } = store.welcome.value ?? {};
  const chosen = useSignal(hosts[0] ?? "");
  /** The start that is to be agreed to. */
  const asked = useSignal<Asked | null>(null);
  const close = () => (store.dialog.value = null);
  const send = async (start: boolean) => {
    asked.value = await studio.send(chosen.value, start, start ? (asked.value?.asks ?? null) : null);
  };
  const refused = store.print.value?.refused ?? "";
  const waits = store.outOfDate.value || !store.print.value || store.sending.value?.share != null;
  if (!hosts.length)
    return (
      <Dialog name="Send to a printer" onClose={close}>
        <NoHosts fault={fault} file={file} />
      </Dialog>
    );
  if (asked.value)
    return (
      <Dialog name={`Print on ${chosen.value} now?`} onClose={close}>
        <About file={asked.value.file} />
        <p class="quiet">It begins by itself once the file is there. Is the bed clear, and this material loaded?</p>
        <div class="answers">
          <button type="button" onClick={() => (asked.value = null)}>
            Back
          </button>
          <button type="button" class="primary" disabled={waits || refused !== ""} onClick={() => void send(true)}>
            Start printing
          </button>
        </div>
      </Dialog>
    );
  return (
    <Dialog name="Send to a printer" onClose={close}>
      <div class="hosts" role="radiogroup" aria-label="host">
        {hosts.map((name) => (
          <label key={name}>
            <input type="radio" name="host" checked={chosen.value === name} onChange={() => (chosen.value = name)} />
            <span>{name}</span>
          </label>
        ))}
      </div>
      <About />
      {refused ? <p class="bad">{`Not sent as it is: ${refused}.`}</p> : null}
      <Under />
      <div class="answers">
        <button type="button" disabled={waits || refused !== ""} onClick={() => void send(false)}>
          Send
        </button>
        <button type="button" class="primary" disabled={waits || refused !== ""} onClick={() => void send(true)}>
          Send and print…
        </button>
      </div>
    </Dialog>
  );
}
