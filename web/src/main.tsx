import { effect } from "@preact/signals";
import { render, type JSX } from "preact";
import { Head, Hints, Messages, Slabs, Timeline, Tools, Views } from "./frame";
import { Icon } from "./icons";
import { KEYS, listen } from "./keys";
import { Panel } from "./panel";
import * as store from "./store";
import { Studio } from "./studio";

function Keys(): JSX.Element | null {
  if (!store.helps.value) return null;
  const close = () => (store.helps.value = false);
  return (
    <div class="veil" onClick={close}>
      <div class="keys" role="dialog" aria-modal="true" aria-label="keys" onClick={(event) => event.stopPropagation()}>
        <h2>Keys</h2>
        <button type="button" class="plain close" aria-label="close" autoFocus onClick={close}>
          <Icon name="close" />
        </button>
        <dl>
          {KEYS.map(([key, does]) => (
            <div key={key}>
              <dt>
                <kbd>{key}</kbd>
              </dt>
              <dd>{does}</dd>
            </div>
          ))}
        </dl>
      </div>
    </div>
  );
}

function mount(id: string, what: JSX.Element): void {
  render(what, document.getElementById(id)!);
}

const stage = document.getElementById("stage")!;
const canvas = document.querySelector("canvas")!;
const probe = document.createElement("canvas").getContext("webgl2");
if (probe) {
  probe.getExtension("WEBGL_lose_context")?.loseContext();
  const studio = new Studio(canvas, stage);
  mount("head", <Head studio={studio} />);
  mount("tools", <Tools studio={studio} />);
  mount("over", (
    <>
      <Views studio={studio} />
      <Slabs />
      <Hints />
      <Messages />
    </>
  ));
  mount("panel", <Panel studio={studio} />);
  mount("foot", <Timeline studio={studio} />);
  mount("keys", <Keys />);
  listen(studio);
  effect(() => {
    stage.dataset["tool"] = store.tool.value;
  });
  // Settings take the session a while to list: they are asked for once a print is there.
  const stop = effect(() => {
    if (!store.print.value && !store.failure.value) return;
    setTimeout(() => {
      void studio.loadFields();
      stop();
    });
  });
  if (new URLSearchParams(location.search).has("debug")) Object.assign(window, { studio, store });
} else {
  stage.textContent = "This page draws with WebGL 2, which this browser does not have or has switched off.";
}
