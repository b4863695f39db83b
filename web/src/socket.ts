// The talk with a session on this machine: one WebSocket, which is opened again when it is lost.
import { Refused, Waiting, type Link } from "./link";
import { decoded, type Answer } from "./protocol";

const FIRST_WAIT_MS = 250;
const LONGEST_WAIT_MS = 4000;

export class SocketLink implements Link {
  private socket: WebSocket | null = null;
  private wait = FIRST_WAIT_MS;
  private readonly waiting = new Waiting();

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
    socket.onmessage = (message: MessageEvent<ArrayBuffer>) => {
      const answer = decoded(message.data);
      if (answer.head.event !== undefined) this.onEvent(answer);
      else this.waiting.answer(answer);
    };
    socket.onclose = () => {
      this.waiting.lost();
      this.onLink(false);
      setTimeout(() => this.open(), this.wait);
      this.wait = Math.min(this.wait * 2, LONGEST_WAIT_MS);
    };
    this.socket = socket;
  }

  ask(message: Record<string, unknown>): Promise<Answer> {
    const socket = this.socket;
    if (!socket || socket.readyState !== WebSocket.OPEN) return Promise.reject(new Refused("the session is not there"));
    return this.waiting.ask(message, (text) => socket.send(text));
  }
}
