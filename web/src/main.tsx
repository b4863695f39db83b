// One bundle for three hosts: a session's window, a notebook's cell, a page of a file.
import { build } from "./app";
import { RecordedLink } from "./recorded";
import { SocketLink } from "./socket";
import * as store from "./store";
import { CommLink, type WidgetModel } from "./widget";

/** Makes a page of the element that a document has for it; what it shows is in the document, or a session tells it. */
export function start(root: HTMLElement): void {
  const data = document.getElementById("data");
  const host = data ? "page" : "studio";
  // What a page of a file shows until it draws, and where it cannot.
  const still = document.querySelector<HTMLImageElement>("#still");
  if (still) store.still.value = still.src;
  still?.remove();
  build(root, host, (take, linked) => (data ? new RecordedLink(data, take, linked) : new SocketLink(take, linked)), window);
}

/** Makes a notebook's view in a shadow tree, which the notebook's own styles do not reach. */
export function widget(model: WidgetModel, el: HTMLElement): () => void {
  const root = document.createElement("div");
  root.style.height = `${model.get("height_px") as number}px`;
  // Keys are the notebook's until the view has the focus.
  root.tabIndex = 0;
  el.attachShadow({ mode: "open" }).append(root);
  let link: CommLink | null = null;
  const close = build(root, "widget", (take, linked) => (link = new CommLink(model, take, linked)), root);
  return () => {
    link?.close();
    close();
  };
}
