/**
 * The live stream: a snapshot, then numbered changes, and every event. What it understands is kept apart from the socket,
 * so that it can be tested without one.
 */
import type { Happening } from "./types";

export interface Sink {
  snapshot(objects: Record<string, Record<string, unknown>>, lastEvent: number): void;
  change(topic: string, key: string, value: unknown): void;
  changed(): void;
  events(events: Happening[]): void;
  /** The events so far belong to another history (another database). */
  forget(): void;
  problem(text: string): void;
}

interface Frame {
  type: string;
  seq?: number;
  last_event?: number;
  objects?: Record<string, Record<string, unknown>>;
  changes?: { topic: string; key: string; value: unknown }[];
  events?: Happening[];
  problem?: { detail?: string };
}

/** What to do about a message: say something, or connect afresh. */
export type Answer = { say: string } | "reconnect" | null;

/** Takes frames in order; tells when a number is missing, or when the server has begun another history. */
export class Stream {
  private seq: number | null = null;
  /** Number of the last event taken, null before the first snapshot. */
  lastEvent: number | null = null;

  constructor(private readonly sink: Sink) {}

  /** A new connection starts with its own snapshot and numbers. */
  restart(): void {
    this.seq = null;
  }

  /** Takes a message; returns what to do about it. */
  take(text: string): Answer {
    const frame = JSON.parse(text) as Frame;
    switch (frame.type) {
      case "snapshot":
        return this.snapshot(frame);
      case "change":
        return this.change(frame);
      case "event":
        this.events(frame.events ?? []);
        return null;
      case "resync":
        this.seq = null;
        return null;
      case "error":
        this.sink.problem(frame.problem?.detail ?? "The server refused the live stream.");
        return null;
      default:
        return null;
    }
  }

  private snapshot(frame: Frame): Answer {
    const last = frame.last_event ?? 0;
    const anew = this.lastEvent !== null && last < this.lastEvent;
    if (anew) this.sink.forget();
    this.seq = frame.seq ?? 0;
    this.sink.snapshot(frame.objects ?? {}, last);
    if (anew || this.lastEvent === null) this.lastEvent = last;
    return anew ? "reconnect" : null;
  }

  private change(frame: Frame): Answer {
    if (this.seq === null) return null;
    if (frame.seq !== this.seq + 1) {
      this.seq = null;
      return { say: JSON.stringify({ resync: true }) };
    }
    this.seq = frame.seq;
    for (const { topic, key, value } of frame.changes ?? []) this.sink.change(topic, key, value);
    this.sink.changed();
    return null;
  }

  private events(events: Happening[]): void {
    const news = events.filter((event) => this.lastEvent === null || event.seq > this.lastEvent);
    const last = news.at(-1);
    if (last === undefined) return;
    this.lastEvent = last.seq;
    this.sink.events(news);
  }
}

export type LinkState = "connecting" | "live" | "lost";

export interface Door {
  /** The address of the stream, with a ticket where the server wants one; null: not allowed to watch now. */
  address(after: number | null): Promise<string | null>;
  /** Whether the server answers; asked when the stream has been silent. */
  alive(): Promise<boolean>;
  state(state: LinkState): void;
}

const PAUSES = [300, 1000, 2000, 4000];
/** Silence on a quiet plant is normal; after this many ms we ask the server whether it is still there. */
const SILENCE = 10_000;

/** Keeps one stream open, for ever. */
export class Watcher {
  private socket: WebSocket | null = null;
  private failures = 0;
  private heard = Date.now();
  private timer = 0;

  constructor(
    private readonly stream: Stream,
    private readonly door: Door,
  ) {
    window.setInterval(() => void this.listen(), SILENCE / 2);
    window.addEventListener("online", () => this.again(0));
  }

  async open(): Promise<void> {
    window.clearTimeout(this.timer);
    if (this.socket) return;
    let address: string | null = null;
    try {
      address = await this.door.address(this.stream.lastEvent);
    } catch {
      this.again();
      return;
    }
    if (address === null || this.socket) return;
    const socket = new WebSocket(address);
    this.socket = socket;
    this.stream.restart();
    socket.onmessage = (message) => this.take(socket, String(message.data));
    socket.onclose = () => this.closed(socket);
  }

  private take(socket: WebSocket, text: string): void {
    if (socket !== this.socket) return;
    this.heard = Date.now();
    this.failures = 0;
    const answer = this.stream.take(text);
    if (answer === "reconnect") {
      this.socket = null;
      socket.close();
      this.again(0);
      return;
    }
    if (answer) socket.send(answer.say);
    this.door.state("live");
  }

  private closed(socket: WebSocket): void {
    if (socket !== this.socket) return;
    this.socket = null;
    this.again();
  }

  private again(pause?: number): void {
    if (this.socket) return;
    this.door.state("lost");
    window.clearTimeout(this.timer);
    const wait = pause ?? PAUSES[Math.min(this.failures++, PAUSES.length - 1)];
    this.timer = window.setTimeout(() => void this.open(), wait);
  }

  private async listen(): Promise<void> {
    const socket = this.socket;
    if (!socket || socket.readyState !== WebSocket.OPEN || Date.now() - this.heard < SILENCE) return;
    if (await this.door.alive()) {
      this.heard = Date.now();
    } else if (socket === this.socket) {
      this.socket = null;
      socket.close();
      this.again();
    }
  }
}
