// A text in a link: deflated, behind its CRC-32, in the letters of base64url. Browsers have had what this takes since
// 2023; without it there is no packed text, and who asks says so.

/** The longest text that is unpacked: a link may come from anyone, and a few letters may stand for gigabytes. */
const UNPACKED = 4 << 20;

/** The longest text in a link, in letters of the link: packed, or as it is where the browser does not pack. */
const LONGEST = 6000;

/** Whether this browser packs. */
export const canPack = (): boolean => typeof CompressionStream === "function" && typeof DecompressionStream === "function";

function crc(bytes: Uint8Array): number {
  let rest = ~0;
  for (const byte of bytes) {
    rest ^= byte;
    for (let bit = 0; bit < 8; bit++) rest = (rest >>> 1) ^ (rest & 1 ? 0xedb88320 : 0);
  }
  return ~rest >>> 0;
}

/** What comes out of a stream that bytes go into; null beyond so many bytes. */
async function through(bytes: Uint8Array, stream: CompressionStream | DecompressionStream, most = Infinity): Promise<Uint8Array | null> {
  const reader = new Blob([bytes as BlobPart]).stream().pipeThrough(stream as unknown as TransformStream<Uint8Array, Uint8Array>).getReader();
  const parts: Uint8Array[] = [];
  let length = 0;
  for (let next = await reader.read(); !next.done; next = await reader.read()) {
    length += next.value.length;
    if (length > most) {
      await reader.cancel();
      return null;
    }
    parts.push(next.value);
  }
  const all = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

/** A text as a link holds it. */
export async function pack(text: string): Promise<string> {
  const bytes = new TextEncoder().encode(text);
  const deflated = (await through(bytes, new CompressionStream("deflate-raw")))!;
  const sum = crc(bytes);
  let letters = "";
  for (const byte of [sum >>> 24, (sum >>> 16) & 255, (sum >>> 8) & 255, sum & 255, ...deflated]) letters += String.fromCharCode(byte);
  return btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** The text that was packed; null where a letter of it was lost or changed. */
export async function unpack(packed: string): Promise<string | null> {
  try {
    const letters = atob(packed.replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
    const text = await through(bytes.subarray(4), new DecompressionStream("deflate-raw"), UNPACKED);
    if (bytes.length < 4 || text === null || crc(text) !== new DataView(bytes.buffer).getUint32(0)) return null;
    return new TextDecoder("utf-8", { fatal: true }).decode(text);
  } catch {
    return null;
  }
}

/** A scene by the keys that links have for it, or why they have none. */
export type Linked = { packed: string } | { scene: string } | { why: string };

/** A scene as links hold it. */
export async function linked(text: string): Promise<Linked> {
  if (!canPack()) return text.length <= LONGEST ? { scene: text } : { why: `it has more than ${LONGEST} letters, and this browser cannot compress it (it lacks CompressionStream)` };
  const packed = await pack(text);
  return packed.length <= LONGEST ? { packed } : { why: `compressed it has ${packed.length} letters, and links of more than ${LONGEST} are cut in places` };
}
