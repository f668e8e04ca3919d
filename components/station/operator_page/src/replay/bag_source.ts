// SPDX-License-Identifier: Apache-2.0
// Where the bytes of a bag come from.

export interface BagSource {
  readonly name: string;
  readonly size: number;
  /** Bytes from `begin` to before `end`. Rejects with a text for people. */
  read(begin: number, end: number): Promise<Uint8Array>;
}

/** Each read goes through another process, or the network: what fits is read once. */
const mostHeldBytes = { file: 256e6, station: 32e6 };

/** A file that the operator has chosen on this computer. */
export function sourceOfFile(file: Blob, name: string): BagSource {
  return held({
    name,
    size: file.size,
    read: async (begin, end) => new Uint8Array(await file.slice(begin, end).arrayBuffer()),
  }, mostHeldBytes.file);
}

/** A recording of the station, which its server gives in parts. */
export function sourceOfUrl(name: string, url: string, size: number, get: typeof fetch, token: string): BagSource {
  const read = async (begin: number, end: number): Promise<Uint8Array> => {
    if (end <= begin) return new Uint8Array();
    const answer = await get(url, { headers: { ...bearer(token), Range: `bytes=${begin}-${end - 1}` } });
    const bytes = new Uint8Array(answer.ok ? await answer.arrayBuffer() : []);
    if (bytes.length === end - begin) return bytes;
    throw new Error(answer.ok ? `it gave ${bytes.length} of ${end - begin} bytes` : (await answer.text()).trim());
  };
  return held({ name, size, read }, mostHeldBytes.station);
}

export const bearer = (token: string): Record<string, string> => (token === "" ? {} : { Authorization: `Bearer ${token}` });

function held(source: BagSource, mostBytes: number): BagSource {
  if (source.size > mostBytes) return source;
  let all: Promise<Uint8Array> | undefined;
  return { ...source, read: async (begin, end) => (await (all ??= source.read(0, source.size))).subarray(begin, end) };
}
