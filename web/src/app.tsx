// The page in any host: its parts, and who they show.
import { effect } from "@preact/signals";
import { render, type JSX } from "preact";
import { Dialog } from "./dialog";
import { Tools } from "./editing";
import { Head, Hints, Messages, Slabs, Still, Timeline, Views } from "./frame";
import { keysOf, listen } from "./keys";
import type { Linking } from "./link";
import { Panel } from "./panel";
import { Sending } from "./sending";
import * as store from "./store";
import { Studio } from "./studio";
import css from "./studio.css";
import { Viewer } from "./viewer";

function Keys({ edits }: { edits: boolean }): JSX.Element {
  return (
    <Dialog name="Keys" onClose={() => (store.dialog.value = null)}>
      <dl class="keys">
        {keysOf(edits).map(([key, does]) => (
          <div key={key}>
            <dt>
              <kbd>{key}</kbd>
            </dt>
            <dd>{does}</dd>
          </div>
        ))}
      </dl>
    </Dialog>
  );
}

function Dialogs({ studio }: { studio: Studio | null }): JSX.Element | null {
  if (store.dialog.value === "keys") return <Keys edits={studio !== null} />;
  return store.dialog.value === "send" && studio ? <Sending studio={studio} /> : null;
}

/** The places of the page's parts; the canvas is the scene's own. */
const PLACES = `
  <div class="app">
    <div data-part="head"></div>
    <div data-part="tools"></div>
    <main class="stage"><canvas aria-label="model and print" role="img"></canvas><div data-part="over"></div></main>
    <div data-part="panel"></div>
    <div data-part="foot"></div>
    <div data-part="dialogs"></div>
  </div>`;

/** Builds the page in an element of a document or of a shadow tree; returns what takes it down. */
export function build(root: HTMLElement, host: typeof store.host.value, linking: Linking, keys: EventTarget): () => void {
  const tree = root.getRootNode() as Document | ShadowRoot;
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(css);
  tree.adoptedStyleSheets.push(sheet);
  root.classList.add("wireprint");
  root.innerHTML = PLACES;
  store.host.value = host;
  const stage = root.querySelector<HTMLElement>(".stage")!;
  const studio = host === "page" ? null : new Studio(root, stage, linking);
  const viewer = studio ?? new Viewer(root, stage, linking);
  const parts: Record<string, JSX.Element> = {
    head: <Head studio={studio} />,
    tools: <Tools studio={studio} />,
    over: (
      <>
        <Still />
        <Views viewer={viewer} />
        <Slabs />
        <Hints />
        <Messages />
      </>
    ),
    panel: <Panel viewer={viewer} studio={studio} />,
    foot: <Timeline viewer={viewer} />,
    dialogs: <Dialogs studio={studio} />,
  };
  const places = Object.entries(parts).map(([name, part]) => {
    const place = root.querySelector(`[data-part="${name}"]`)!;
    render(part, place);
    return place;
  });
  const deaf = listen(viewer, studio, keys);
  const stop = effect(() => {
    stage.dataset["tool"] = store.tool.value;
  });
  if (studio) askForFields(studio);
  if (new URLSearchParams(location.search).has("debug")) Object.assign(window, { studio: viewer, store });
  viewer.open();
  return () => {
    deaf();
    stop();
    viewer.close();
    for (const place of places) render(null, place);
  };
}

/** Settings take the session a while to list: they are asked for once a print is there. */
function askForFields(studio: Studio): void {
  const stop = effect(() => {
    if (!store.print.value && !store.failure.value) return;
    setTimeout(() => {
      void studio.loadFields();
      stop();
    });
  });
}
