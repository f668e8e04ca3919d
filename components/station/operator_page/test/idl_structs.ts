// SPDX-License-Identifier: Apache-2.0
import fs from "node:fs";
import path from "node:path";

const idl = path.join(import.meta.dirname, "../../../../idl");
const basic: Record<string, string> = {
  "unsigned long long": "uint64", "long long": "int64", "unsigned long": "uint32", long: "int32",
  double: "float64", float: "float32", boolean: "bool", octet: "byte", uint8: "uint8",
};

const rosType = (text: string): string => {
  const list = /^sequence<(.*)>$/.exec(text);
  if (list?.[1]) return `${rosType(list[1])}[]`;
  return basic[text] ?? text.replace("::msg::", "/");
};

/** Fields of all structs, by "package/Type": "type name". */
export function structs(): Map<string, string[]> {
  const found = new Map<string, string[]>();
  for (const folder of ["ros_idl", "tocsin_idl"]) {
    for (const file of fs.readdirSync(path.join(idl, folder, "idl"))) {
      const text = fs.readFileSync(path.join(idl, folder, "idl", file), "utf8").replace(/\/\/.*/g, "");
      const module = /module (\w+) \{\s*module msg/.exec(text)?.[1] ?? "";
      for (const [, name, body] of text.matchAll(/struct (\w+) \{([^}]*)\}/g)) {
        const fields = [...(body ?? "").matchAll(/^\s*(?:@default\([^)]*\)\s*)?([\w:<> ]+?)\s+(\w+)(\[\d+\])?;/gm)];
        found.set(`${module}/${name}`, fields.map(([, type, field]) => `${rosType(type ?? "")} ${field}`));
      }
    }
  }
  return found;
}
