// The talk with a notebook: messages and answers by its comm, as anywidget passes them on.
import { Waiting, type Link } from "./link";
import { decoded, type Answer } from "./protocol";

/** What of anywidget's model is used. */
export interface WidgetModel {
  get(name: string): unknown;
  send(content: unknown): void;
  on(event: string, call: (content: unknown, buffers: DataView[]) => void): void;
  off(event: string, call: (content: unknown, buffers: DataView[]) => void): void;
}

export class CommLink implements Link {
  private readonly waiting = new Waiting();

  constructor(
    private readonly model: WidgetModel,
    private readonly onEvent: (answer: Answer) => void,
    private readonly onLink: (open: boolean) => void,
  ) {}

  open(): void {
    this.model.on("msg:custom", this.take);
    this.onLink(true);
    // The kernel tells everything that is known to whoever says this.
    this.model.send(JSON.stringify({ do: "open" }));
  }

  close(): void {
    this.model.off("msg:custom", this.take);
    this.waiting.lost();
  }

  ask(message: Record<string, unknown>): Promise<Answer> {
    return this.waiting.ask(message, (text) => this.model.send(text));
  }

  private readonly take = (_content: unknown, buffers: DataView[]): void => {
    for (const { buffer, byteOffset, byteLength } of buffers) {
      const answer = decoded((buffer as ArrayBuffer).slice(byteOffset, byteOffset + byteLength));
      if (answer.head.event !== undefined) this.onEvent(answer);
      else this.waiting.answer(answer);
    }
  };
}
