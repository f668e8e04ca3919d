// SPDX-License-Identifier: Apache-2.0
import { render } from "preact";

import { socketOf } from "./fleet/addresses.ts";
import { Fleet } from "./fleet/fleet.ts";
import { pageNow } from "./page_now.ts";
import { FleetPage } from "./view/fleet_page.tsx";

const place = document.getElementById("page");
if (place !== null) {
  const here = window.location.href;
  const fleet = new Fleet(here, socketOf(here), pageNow);
  setInterval(() => fleet.tick(), 50);
  render(<FleetPage fleet={fleet} />, place);
}
