// SPDX-License-Identifier: Apache-2.0
import { render } from "preact";

import { Operator, pageNow } from "./operator.ts";
import { Page } from "./view/page.tsx";

/** The server that the page came from, with the token of the page's own address. */
function serverUrl(): string {
  const url = new URL(window.location.href);
  url.protocol = url.protocol === "https:" ? "wss:" : "ws:";
  const token = url.searchParams.get("token");
  url.search = token === null ? "" : `?token=${encodeURIComponent(token)}`;
  url.hash = "";
  return url.href;
}

const place = document.getElementById("page");
if (place !== null) {
  const operator = new Operator(serverUrl(), window.location.href);
  setInterval(() => operator.tick(pageNow()), 50);
  render(<Page operator={operator} />, place);
}
