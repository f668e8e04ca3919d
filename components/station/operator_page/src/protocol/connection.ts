// SPDX-License-Identifier: Apache-2.0
// The connection to the station's server: comes back by itself, with all subscriptions, and finds
// out by silence when the other end is gone without a word (browsers cannot ping).
import { type Channel, FoxgloveClient, type IWebSocket, type Service } from "@foxglove/ws-protocol";

import { type Decode, type Encode, decoderOf, encoderOf } from "./codec.ts";
import { type Published, allPublished, emergencyStopRequest } from "./published.ts";
import { nameIn } from "./topic_name.ts";

/** Both names of the protocol; the server chooses. */
export const subprotocols = ["foxglove.sdk.v1", "foxglove.websocket.v1"];
/** Containers of the station tell their state each second, so that silence is a dead connection. */
export const silenceLimitMs = 5000;
const retryDelaysMs = [300, 600, 1200, 2500];

export type Phase = "connecting" | "open" | "lost";

/** How the connection stands. */
export interface ConnectionState {
  readonly phase: Phase;
  /** Since when, in the time of `now`. */
  readonly since: number;
  readonly tries: number;
  /** Why it was lost, for people. */
  readonly reason: string;
}

/** What a client may do; everybody may press the emergency stop. */
export const userRoles = ["observer", "operator", "supervisor"] as const;
export type UserRole = (typeof userRoles)[number];

/** A server with what it said of itself. */
export interface ServerInfo {
  readonly name: string;
  /** Of this client; another server than ours tells none and refuses by itself. */
  readonly role: UserRole;
  readonly metadata: Readonly<Record<string, string>>;
}

export interface ConnectionOptions {
  readonly url: string;
  /** Topics to subscribe to, without the leading slash. */
  readonly topics: ReadonlySet<string>;
  /** A message; `logTimeMs`: when the server got it, by its clock [ms]. */
  readonly onMessage: (topic: string, message: unknown, logTimeMs: number) => void;
  readonly onServer: (server: ServerInfo) => void;
  /** A parameter that is watched, and each time that it changes. */
  readonly onParameter: (name: string, value: unknown) => void;
  /** What the server or a broken message has to say. */
  readonly onTrouble: (text: string) => void;
  readonly now: () => number;
  readonly openSocket: (url: string, subprotocols: string[]) => IWebSocket;
}

/** A call that is under way. */
interface PendingCall {
  readonly decode: Decode;
  readonly resolve: (response: unknown) => void;
  readonly reject: (reason: Error) => void;
}

interface Subscription {
  readonly topic: string;
  readonly channel: number;
  readonly decode: Decode;
}

export class Connection {
  state: ConnectionState;
  /** Topics that the server offers now. */
  readonly offered = new Set<string>();
  #client: FoxgloveClient | undefined;
  #subscriptions = new Map<number, Subscription>();
  #channels = new Map<string, number>();
  #encoders = new Map<string, Encode>();
  #services = new Map<string, Service>();
  #calls = new Map<number, PendingCall>();
  #lastCall = 0;
  #heard = 0;
  #retryAt = 0;
  #paused = new Set<string>();
  #known = new Map<string, Channel>();
  /** Of the vehicle that this server is for, where there are several. */
  #namespace = "";

  constructor(private readonly options: ConnectionOptions) {
    this.state = { phase: "connecting", since: options.now(), tries: 0, reason: "" };
    this.#open();
  }

  /** To be called a few times a second: closes what is silent, opens what is due. */
  tick(): void {
    const now = this.options.now();
    const waits = this.state.phase !== "lost";
    if (waits && now - this.#heard > silenceLimitMs) this.#lose("the server says nothing");
    if (this.state.phase === "lost" && now >= this.#retryAt) this.#open();
  }

  /** False when it could not be sent. */
  publish(what: Published, message: unknown): boolean {
    const channel = this.#channels.get(what.topic);
    if (this.#client === undefined || this.state.phase !== "open" || channel === undefined) return false;
    let encode = this.#encoders.get(what.topic);
    if (encode === undefined) this.#encoders.set(what.topic, (encode = encoderOf(what.text)));
    try {
      this.#client.sendMessage(channel, encode(message));
      return true;
    } catch (error) {
      this.options.onTrouble(`${what.topic} was not sent: ${String(error)}`);
      return false;
    }
  }

  /** Calls a service, by its name without the slash. Rejects with the server's reason, or that of the loss. */
  call(name: string, request: object): Promise<unknown> {
    const service = this.#services.get(name);
    const client = this.#client;
    if (client === undefined || this.state.phase !== "open") return Promise.reject(new Error("no connection to the station"));
    if (service?.request === undefined || service.response === undefined) return Promise.reject(new Error(`nobody serves ${name}`));
    const { request: asked, response: answered } = service;
    return new Promise((resolve, reject) => {
      const data = encoderOf(asked.schema)(request);
      const decode = decoderOf({ name: answered.schemaName, encoding: answered.schemaEncoding, text: answered.schema });
      if (decode === undefined) throw new Error(`${name}: schemas in ${answered.schemaEncoding} are not read here`);
      this.#calls.set(++this.#lastCall, { decode, resolve, reject });
      client.sendServiceCallRequest({ serviceId: service.id, callId: this.#lastCall, encoding: "cdr", data });
    });
  }

  /** Asks for parameters, `/node.parameter`, and for their changes as long as this connection is there. */
  watchParameters(names: string[]): void {
    this.#client?.subscribeParameterUpdates(names);
    this.#client?.getParameters(names, "watched");
  }

  /** False when it could not be sent. What came of it is told as a change. */
  setParameter(name: string, value: boolean): boolean {
    if (this.#client === undefined || this.state.phase !== "open") return false;
    this.#client.setParameters([{ name, value, type: undefined }], "set");
    return true;
  }

  /** A topic that nobody looks at need not come. */
  want(topic: string, wanted: boolean): void {
    if (wanted !== this.#paused.has(topic)) return;
    if (wanted) this.#paused.delete(topic);
    else this.#paused.add(topic);
    const known = this.#known.get(topic);
    if (known === undefined || this.#client === undefined) return;
    if (wanted) this.#subscribe([known]);
    else this.#unsubscribe(known.id);
  }

  #open(): void {
    const { options } = this;
    const tries = this.state.tries + 1;
    this.state = { ...this.state, phase: "connecting", tries };
    this.#heard = options.now();
    let socket: IWebSocket;
    try {
      socket = options.openSocket(options.url, subprotocols);
    } catch (error) {
      this.#lose(String(error));
      return;
    }
    this.#client = new FoxgloveClient({ ws: socket });
    this.#listen(this.#client);
  }

  #listen(client: FoxgloveClient): void {
    const { options } = this;
    const mine = <Arguments extends unknown[]>(handle: (...args: Arguments) => void) => {
      return (...args: Arguments): void => {
        if (this.#client !== client) return; // of a connection that was given up
        this.#heard = options.now();
        handle(...args);
      };
    };
    client.on("open", mine(() => this.#opened()));
    client.on("serverInfo", mine((info) => {
      this.#namespace = info.metadata?.namespace ?? "";
      const metadata = info.metadata ?? {};
      const role = userRoles.find((one) => one === metadata.role) ?? "operator";
      this.#advertise(role === "observer" ? [emergencyStopRequest] : allPublished);
      options.onServer({ name: info.name, role, metadata });
    }));
    client.on("status", mine((status) => options.onTrouble(status.message)));
    client.on("advertise", mine((channels) => this.#subscribe(channels)));
    client.on("unadvertise", mine((ids) => ids.forEach((id) => this.#unadvertised(id))));
    client.on("advertiseServices", mine((services) => services.forEach((service) => this.#served(service))));
    client.on("unadvertiseServices", mine((ids) => {
      for (const [name, { id }] of this.#services) if (ids.includes(id)) this.#services.delete(name);
    }));
    client.on("serviceCallResponse", mine(({ callId, data }) => this.#answered(callId, (call) => call.resolve(call.decode(data)))));
    client.on("serviceCallFailure", mine(({ callId, message }) => {
      this.#answered(callId, (call) => call.reject(new Error(message)));
    }));
    client.on("time", mine(() => undefined));
    client.on("parameterValues", mine(({ parameters }) => {
      for (const { name, value } of parameters) options.onParameter(name, value);
    }));
    client.on("message", mine(({ subscriptionId, timestamp, data }) => {
      this.#message(subscriptionId, Number(timestamp / 1000n) / 1000, data);
    }));
    client.on("error", mine(() => undefined)); // a close follows
    client.on("close", mine((event) => this.#lose(closeReason(event))));
  }

  #opened(): void {
    this.state = { phase: "open", since: this.options.now(), tries: 0, reason: "" };
  }

  /** Once the namespace is known, which the server tells first. */
  #advertise(published: readonly Published[]): void {
    const home = this.#namespace === "" ? "/" : `/${this.#namespace}/`;
    for (const { topic, schemaName } of published) {
      const id = this.#client?.advertise({ topic: home + topic, schemaName, encoding: "cdr" });
      if (id !== undefined) this.#channels.set(topic, id);
    }
  }

  #served(service: Service): void {
    const name = nameIn(this.#namespace, service.name);
    if (name !== undefined) this.#services.set(name, service);
  }

  #subscribe(channels: Channel[]): void {
    for (const channel of channels) {
      const topic = nameIn(this.#namespace, channel.topic);
      if (topic === undefined) continue;
      this.offered.add(topic);
      if (!this.options.topics.has(topic) || channel.encoding !== "cdr") continue;
      this.#known.set(topic, channel);
      if (this.#paused.has(topic)) continue;
      const decode = this.#decoder(channel);
      if (decode === undefined || this.#client === undefined) continue;
      const id = this.#client.subscribe(channel.id);
      this.#subscriptions.set(id, { topic, channel: channel.id, decode });
    }
  }

  #decoder(channel: Channel): Decode | undefined {
    const encoding = channel.schemaEncoding ?? "ros2msg";
    try {
      const decode = decoderOf({ name: channel.schemaName, encoding, text: channel.schema });
      if (!decode) this.options.onTrouble(`${channel.topic}: schemas in ${encoding} are not read here`);
      return decode;
    } catch (error) {
      this.options.onTrouble(`${channel.topic}: its schema cannot be read: ${String(error)}`);
      return undefined;
    }
  }

  #unsubscribe(channel: number): void {
    for (const [id, subscription] of this.#subscriptions) {
      if (subscription.channel !== channel) continue;
      this.#subscriptions.delete(id);
      this.#client?.unsubscribe(id);
    }
  }

  #unadvertised(channel: number): void {
    for (const [id, subscription] of this.#subscriptions) {
      if (subscription.channel === channel) this.#subscriptions.delete(id);
    }
    for (const [topic, known] of this.#known) {
      if (known.id !== channel) continue;
      this.#known.delete(topic);
      this.offered.delete(topic);
    }
  }

  #message(subscription: number, logTimeMs: number, data: ArrayBufferView): void {
    const found = this.#subscriptions.get(subscription);
    if (found === undefined) return; // unsubscribed while it was on its way
    let message: unknown;
    try {
      message = found.decode(data);
    } catch (error) {
      this.options.onTrouble(`${found.topic}: a message cannot be read: ${String(error)}`);
      return;
    }
    this.options.onMessage(found.topic, message, logTimeMs);
  }

  #answered(id: number, end: (call: PendingCall) => void): void {
    const call = this.#calls.get(id);
    this.#calls.delete(id);
    if (call === undefined) return;
    try {
      end(call);
    } catch (error) {
      call.reject(new Error(`the answer cannot be read: ${String(error)}`));
    }
  }

  #lose(reason: string): void {
    const now = this.options.now();
    const { phase, tries } = this.state;
    const wasOpen = phase === "open";
    const delay = retryDelaysMs[Math.min(tries, retryDelaysMs.length) - 1] ?? retryDelaysMs[0] ?? 0;
    this.#retryAt = now + delay;
    this.state = { phase: "lost", since: wasOpen ? now : this.state.since, tries, reason };
    const client = this.#client;
    this.#client = undefined;
    this.#subscriptions.clear();
    this.#channels.clear();
    this.#known.clear();
    this.#services.clear();
    for (const { reject } of this.#calls.values()) reject(new Error(`the connection was lost before an answer: ${reason}`));
    this.#calls.clear();
    this.offered.clear();
    client?.close();
  }
}

function closeReason(event: unknown): string {
  const { code, reason } = event as { code?: number; reason?: string };
  if (reason) return reason;
  if (code === 1006) return "no server answers";
  return `closed with code ${String(code)}`;
}
