// SPDX-License-Identifier: Apache-2.0
import { render } from "preact";

import { socketOf } from "./fleet/addresses.ts";
import { Operator } from "./operator.ts";
import { pageNow } from "./page_now.ts";
import { Page } from "./view/page.tsx";

const place = document.getElementById("page");
if (place !== null) {
  const operator = new Operator(socketOf(window.location.href), window.location.href);
  setInterval(() => operator.tick(pageNow()), 50);
  render(<Page operator={operator} />, place);
}
