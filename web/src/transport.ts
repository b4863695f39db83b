// The talk with the session: one WebSocket, which is opened again when it is lost.
import { decoded, type Answer } from "./protocol";

const FIRST_WAIT_MS = 250;
const LONGEST_WAIT_MS = 4000;

export class Refused extends Error {}

export class Transport {
  private socket: WebSocket | null = null;
  private number = 0;
  private wait = FIRST_WAIT_MS;
  private readonly waiting = new Map<number, { resolve: (answer: Answer) => void; reject: (error: Error) => void }>();

  constructor(
    private readonly onEvent: (answer: Answer) => void,
    private readonly onLink: (open: boolean) => void,
  ) {}

  open(): void {
    const socket = new WebSocket(`ws://${location.host}/messages`);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      this.wait = FIRST_WAIT_MS;
      this.onLink(true);
    };
    socket.onmessage = (message: MessageEvent<ArrayBuffer>) => this.take(decoded(message.data));
    socket.onclose = () => {
      for (const { reject } of this.waiting.values()) reject(new Refused("the session was lost"));
      this.waiting.clear();
      this.onLink(false);
      setTimeout(() => this.open(), this.wait);
      this.wait = Math.min(this.wait * 2, LONGEST_WAIT_MS);
    };
    this.socket = socket;
  }

  /** Sends a message and waits for its answer; what is refused is thrown. */
  ask(message: Record<string, unknown>): Promise<Answer> {
    const socket = this.socket;
    if (!socket || socket.readyState !== WebSocket.OPEN) return Promise.reject(new Refused("the session is not there"));
    const id = ++this.number;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      socket.send(JSON.stringify({ ...message, id }));
    });
  }

  private take(answer: Answer): void {
    if (answer.head.event !== undefined) {
      this.onEvent(answer);
      return;
    }
    const waits = this.waiting.get(answer.head.re ?? -1);
    if (!waits) return;
    this.waiting.delete(answer.head.re ?? -1);
    if (answer.head.error !== undefined) waits.reject(new Refused(answer.head.error));
    else waits.resolve(answer);
  }
}
