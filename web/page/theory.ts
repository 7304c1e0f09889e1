// The Theory panel: exact numbers in, tables out: which orbits exist at a point, the numbers that decide it,
// the impact patterns; and small certificates, made here and checked in the Check panel.

import { Lane } from "./compute";
import { type Context, element, Failure, type Panel, scroller } from "./panel";

/** Certificates may take long to find: they have a worker of their own, which can be ended. */
const lane = new Lane();

type Cell = Node | string | number | null | undefined;

/** A table of rows, with an empty cell where there is nothing to say. */
function table(caption: string, heads: string[], rows: Cell[][]): HTMLElement {
  const head = element("tr", {}, ...heads.map((text) => element("th", { scope: "col" }, text)));
  const body = rows.map((row) =>
    element("tr", {}, ...row.map((cell) => element("td", {}, cell instanceof Node ? cell : String(cell ?? "")))),
  );
  const made = element("table", { class: "numbers" }, element("caption", {}, caption), element("thead", {}, head));
  made.append(element("tbody", {}, ...body));
  return scroller(caption, made);
}

const sign = (value: number | null): string => (value === null ? "" : value > 0 ? "+" : "−");

/** A text in which `b_{5,2}` and `c_5` have their indices below. */
function formula(text: string): HTMLElement {
  const made = element("span");
  for (const [index, part] of text.split(/_(?:\{([^}]*)\}|(\w+))/).entries()) {
    if (part) made.append(index % 3 === 0 ? part : element("sub", {}, part));
  }
  return made;
}

/** Why there is no orbit. */
function because(row: Record<string, number | string | null>): HTMLElement {
  const { n, positive_k, negative_k, zero_k, resonance } = row;
  if (resonance !== null) return formula(`${resonance} resonance`);
  if (zero_k !== null) return formula(`b_{${n},${zero_k}} = 0`);
  return formula(positive_k === null ? "" : `b_{${n},${positive_k}} > 0 > b_{${n},${negative_k}}`);
}

/** The fields by the names of the program's arguments. */
const FIELDS: Record<string, string> = {
  a1: "a₁",
  a2: "a₂",
  max_n: "periods up to",
  max_period: "patterns of period up to",
  last: "Certificate for n",
};

/** A field with its label. */
function field(label: string, value: string, size: number): { input: HTMLInputElement; label: HTMLLabelElement } {
  const input = element("input", { value, size, spellcheck: "false", autocomplete: "off" });
  return { input, label: element("label", {}, `${label} `, input) };
}

let restore: (state: URLSearchParams) => void = () => {};

export const theory: Panel = {
  id: "theory",
  title: "Theory",
  mount(root: HTMLElement, context: Context): void {
    const place = element(
      "select",
      { id: "theory-place" },
      element("option", { value: "polar" }, "modulus r and angle s"),
      element("option", { value: "plane" }, "trace a₁ and determinant a₂"),
    );
    const x = field("r", "0.99", 24);
    const y = field("s", "3/8+2^-200", 24);
    const periods = field("periods up to", "12", 5);
    const n = field("n", "5", 5);
    const bits = field("bits", "128", 5);
    const longest = field("patterns of period up to", "5", 3);
    const out = element("div", { id: "theory-out" });
    const cancel = element("button", { type: "button" }, "Cancel");
    const busy = element("div", { class: "row muted", hidden: true }, "Computing…", cancel);
    const button = (text: string): HTMLButtonElement => element("button", { type: "button" }, text);
    const [orbits, values, patterns] = [button("Which orbits exist"), button("Values and signs"), button("Impact patterns")];
    const certificate = field("Certificate for n =", "3..=12", 10);
    const [prove, cover] = [button("Theorem 2"), button("Conjecture 1 (cover)")];
    orbits.classList.add("first");

    const names = (): void => {
      const polar = place.value === "polar";
      (x.label.firstChild as Text).data = polar ? "r " : "a₁ ";
      (y.label.firstChild as Text).data = polar ? "s " : "a₂ ";
    };
    const at = (): [string, string, string] => [place.value, x.input.value, y.input.value];
    const link = (): void => {
      const [where, first, second] = at();
      context.permalink({ place: where, x: first, y: second, n: periods.input.value });
    };
    /** What a link asks for is no step of the reader's. */
    let restoring = false;
    /** Counts what was asked for: an answer to an earlier question is not shown. */
    let turn = 0;
    /** Does the work and shows its table, or what is wrong; a certificate, as text, goes to the Check panel. */
    const run = async (name: string, work: () => Promise<HTMLElement | string>): Promise<void> => {
      const mine = ++turn;
      if (!restoring) context.step();
      link();
      lane.cancel("The search was cancelled.");
      busy.hidden = false;
      let shown: HTMLElement | string;
      let said = `${name}: done`;
      try {
        shown = await work();
      } catch (thrown) {
        const failure = thrown instanceof Failure ? thrown : new Failure(String(thrown));
        said = `${failure.key ? `${FIELDS[failure.key] ?? failure.key}: ` : ""}${failure.message}`;
        shown = element("p", { class: "notice bad" }, said);
      }
      if (mine !== turn) return;
      busy.hidden = true;
      if (typeof shown === "string") {
        context.openCheck(shown);
      } else {
        out.replaceChildren(shown);
        context.announce(said);
      }
    };
    const whole = (input: HTMLInputElement, key: string): number => {
      const value = Number(input.value);
      if (!/^\s*\d+\s*$/.test(input.value) || value > 4e9) {
        throw new Failure(`“${input.value}” is not a whole number`, undefined, key);
      }
      return value;
    };

    orbits.addEventListener("click", () =>
      run("Which orbits exist", async () => {
        const found = await context.compute("classify", ...at(), whole(periods.input, "max_n"));
        const rows = found.rows.map((row: Record<string, any>) => [
          row.n,
          row.existence,
          sign(row.sign_emu),
          sign(row.sign_gamma),
          sign(row.large_eigenvalue),
          because(row),
        ]);
        const caption = `${found.region}${found.reversed ? ", after reversing time" : ""}`;
        const shown = table(caption, ["n", "orbit", "eµ", "γ", "large eigenvalue", "because"], rows);
        const born = found.resonances.map((text: string) => element("p", {}, formula(text)));
        return element("div", {}, ...born, shown);
      }),
    );
    values.addEventListener("click", () =>
      run("Values and signs", async () => {
        const period = whole(n.input, "n");
        const found = await context.compute("evaluate", ...at(), period, 0, whole(bits.input, "bits"));
        const rows = found.values.map((row: Record<string, any>) => [
          formula(row.name),
          row.sign,
          row.decided_by,
          row.value,
        ]);
        const caption = "Every digit is certain: a number is off by less than one unit of its last.";
        return table(caption, ["quantity", "sign", "decided by", "value"], rows);
      }),
    );
    patterns.addEventListener("click", () =>
      run("Impact patterns", async () => {
        if (place.value !== "plane") throw new Failure("the patterns are those of a trace a₁ and a determinant a₂");
        const last = whole(longest.input, "max_period");
        const blocks: Node[] = [];
        for (const positive of [true, false]) {
          const found = await context.compute("existence", x.input.value, y.input.value, positive, last);
          const rows = found.rows.map((row: Record<string, any>) => [row.pattern, row.period, row.verdict, row.reason]);
          blocks.push(table(`γ ${positive ? ">" : "<"} 0`, ["pattern", "n", "exists for", "open because"], rows));
        }
        return element("div", { class: "columns" }, ...blocks);
      }),
    );
    const range = (): [number, number] => {
      const [, first, last] = certificate.input.value.match(/^\s*(\d{1,4})\s*(?:(?:\.\.=?|–|-)\s*(\d{1,4})\s*)?$/) ?? [];
      if (!first) throw new Failure(`“${certificate.input.value}” is no range of periods, such as 3..=12`, undefined, "last");
      return [Number(first), Number(last ?? first)];
    };
    prove.addEventListener("click", () =>
      run("Theorem 2", async () => {
        return (await lane.call("theorem2", range())).certificate as string;
      }),
    );
    cover.addEventListener("click", () =>
      run("Conjecture 1", async () => {
        const found = await lane.call("cover", [...range(), ""]);
        if (found.certificate) return found.certificate as string;
        const heads = ["n", "verdict", "leaves", "open"];
        return table("Not every period is proved.", heads, found.periods.map((row: any) => heads.map((key) => row[key])));
      }),
    );
    cancel.addEventListener("click", () => lane.cancel("The search was cancelled."));
    place.addEventListener("change", () => {
      names();
      [x.input.value, y.input.value] = place.value === "polar" ? ["0.99", "3/8+2^-200"] : ["-3/2", "9/10"];
    });
    names();

    root.append(
      element(
        "p",
        { class: "muted" },
        "Numbers are exact: 3/8+2^-200, 0.99 or -3/2, as on the command line. Signs are certain, or said to be undecided.",
      ),
      element("div", { class: "row" }, element("label", {}, "A point by ", place), x.label, y.label),
      element("div", { class: "row" }, orbits, periods.label),
      element("div", { class: "row" }, values, n.label, bits.label),
      element("div", { class: "row" }, patterns, longest.label),
      element("div", { class: "row" }, certificate.label, prove, cover),
      busy,
      out,
    );
    for (const { input } of [x, y, periods]) {
      input.addEventListener("keydown", (event) => {
        if (event.key === "Enter") orbits.click();
      });
    }
    restore = (state) => {
      const [where, first, second] = [state.get("place"), state.get("x"), state.get("y")];
      if (first === null && second === null) return;
      if (where === "polar" || where === "plane") place.value = where;
      names();
      if (first !== null) x.input.value = first;
      if (second !== null) y.input.value = second;
      periods.input.value = state.get("n") ?? periods.input.value;
      restoring = true;
      orbits.click();
      restoring = false;
    };
  },
  restore(state: URLSearchParams): void {
    restore(state);
  },
};
