// How a page talks with what it is a page of: a session by WebSocket, a notebook, or its own file.
import type { Answer } from "./protocol";

export class Refused extends Error {}

export interface Link {
  /** Begins: events are told from then on. */
  open(): void;
  /** Sends a message and waits for its answer; what is refused is thrown, as `Refused`. */
  ask(message: Record<string, unknown>): Promise<Answer>;
}

/** Makes a link that tells events, and whether it stands. */
export type Linking = (onEvent: (answer: Answer) => void, onLink: (open: boolean) => void) => Link;

/** The messages that wait for an answer. */
export class Waiting {
  /** Those of several pages on one comm do not meet. */
  private number = Math.floor(Math.random() * 2 ** 40);
  private readonly waiting = new Map<number, { resolve: (answer: Answer) => void; reject: (error: Error) => void }>();

  /** Numbers a message, sends it, and waits. */
  ask(message: Record<string, unknown>, send: (text: string) => void): Promise<Answer> {
    const id = ++this.number;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      send(JSON.stringify({ ...message, id }));
    });
  }

  /** Gives an answer to who waits for it. */
  answer(answer: Answer): void {
    const number = answer.head.re ?? -1;
    const waits = this.waiting.get(number);
    if (!waits) return;
    this.waiting.delete(number);
    if (answer.head.error !== undefined) waits.reject(new Refused(answer.head.error));
    else waits.resolve(answer);
  }

  /** Lets down all who wait. */
  lost(): void {
    for (const { reject } of this.waiting.values()) reject(new Refused("the session was lost"));
    this.waiting.clear();
  }
}
