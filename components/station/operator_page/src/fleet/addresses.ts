// SPDX-License-Identifier: Apache-2.0
// Where the pages of a fleet's vehicles are.

/** A vehicle and the address of its page. */
export interface Address {
  readonly name: string;
  readonly page: string;
}

/** Of the server's text, "uxv1=http://127.0.0.1:8761/ uxv2=...". */
export function addressesOf(text: string): Address[] {
  const found: Address[] = [];
  for (const item of text.split(" ")) {
    const at = item.indexOf("=");
    if (at > 0) found.push({ name: item.slice(0, at), page: item.slice(at + 1) });
  }
  return found;
}

/** With the token of the page that this one is. */
export function withToken(page: string, here: string): string {
  const url = new URL(page);
  const token = new URL(here).searchParams.get("token");
  if (token !== null) url.searchParams.set("token", token);
  return url.href;
}

/** The socket beside a page, with its token. */
export function socketOf(page: string): string {
  const url = new URL(".", page);
  const token = new URL(page).searchParams.get("token");
  url.protocol = url.protocol === "https:" ? "wss:" : "ws:";
  url.search = token === null ? "" : `?token=${encodeURIComponent(token)}`;
  return url.href;
}
