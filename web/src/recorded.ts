// A page that holds all that it shows: what a session would tell stands in it, deflated, and nobody answers.
import { Refused, type Link } from "./link";
import { decoded, type Answer } from "./protocol";

export class RecordedLink implements Link {
  constructor(
    private readonly held: HTMLElement,
    private readonly onEvent: (answer: Answer) => void,
    private readonly onLink: (open: boolean) => void,
  ) {}

  open(): void {
    void this.read();
  }

  ask(): Promise<Answer> {
    return Promise.reject(new Refused("a page of a file only shows"));
  }

  private async read(): Promise<void> {
    const deflated = Uint8Array.from(atob(this.held.textContent ?? ""), (letter) => letter.charCodeAt(0));
    const stream = new Blob([deflated]).stream().pipeThrough(new DecompressionStream("deflate"));
    const bytes = await new Response(stream).arrayBuffer();
    this.onLink(true);
    // Each event after its length, u32.
    const lengths = new DataView(bytes);
    for (let at = 0; at < bytes.byteLength; ) {
      const length = lengths.getUint32(at, true);
      at += 4;
      this.onEvent(decoded(bytes.slice(at, at + length)));
      at += length;
    }
  }
}
