(* `grazing-proved`: a reader of certificates of kinds theorem2, word, word-by-theorem, chaos 3, range, range 2 and
   attractor: one answer per file named on the command line (after --, whatever its name): "proved", "refused: line N:
   ..." or "not read: ...". Every file is read to its end. Of chaos 3 and of ranges the motions and the growth of the
   graph are proved, and the answer says what of the statement is not read: "proved; reach, entropy: not read", or with
   others where the file claims that there are none. What a file claims is decided by the proved functions of
   StatementReaders.v, StatementReaderWords.v, StatementGrowth.v, PathsCheck.v, RangesCheck.v and TrapsCheck.v; here
   files are cut into lines and words, numbers are read, and the form is checked, as the heads of mod.rs in
   crates/checker/src, in theorem2, word, chaos, range and attractor, have it. *)
open Decide

exception Refused of string
exception Not_read of string
let refuse reason = raise (Refused reason)
let need holds reason = if not holds then refuse reason

(* ---- numbers ---- *)
let rec positive k = if k = 1 then XH else if k land 1 = 1 then XI (positive (k / 2)) else XO (positive (k / 2))
let whole k = if k = 0 then Z0 else if k > 0 then Zpos (positive k) else Zneg (positive (-k))
let rec natural k = if k = 0 then O else S (natural (k - 1))
let ten = whole 10
let canonical word =
  word <> "" && String.for_all (fun c -> '0' <= c && c <= '9') word && (word = "0" || word.[0] <> '0')
let small what most word =
  need (canonical word && String.length word <= 9 && int_of_string word <= most) ("expected " ^ what);
  int_of_string word
let large word = String.fold_left (fun v d -> Z.add (Z.mul ten v) (whole (Char.code d - Char.code '0'))) Z0 word
let prime p q = Z.gcd p q = whole 1

(* ---- lines and words ---- *)
type lines = { mutable rest : string list; mutable number : int }

let lines_of text =
  let rec ends read = function
    | [] | [ "" ] -> List.rev read
    (* A last line without its end keeps a carriage return. *)
    | [ line ] -> List.rev (line :: read)
    | line :: rest ->
        let n = String.length line in
        ends ((if n > 0 && line.[n - 1] = '\r' then String.sub line 0 (n - 1) else line) :: read) rest in
  { rest = ends [] (String.split_on_char '\n' text); number = 0 }

let next lines =
  lines.number <- lines.number + 1;
  match lines.rest with
  | [] -> lines.number <- lines.number - 1; None
  | line :: rest -> lines.rest <- rest; Some line
let expect ?(longest = 1000) lines what =
  match next lines with
  | None -> lines.number <- lines.number + 1; refuse ("the file ends where " ^ what ^ " should stand")
  | Some line -> need (String.length line <= longest) "the line is too long"; line
let words line = String.split_on_char ' ' line
let value lines name most =
  match words (expect lines name) with
  | [ word; number ] when word = name -> small name most number
  | _ -> refuse ("expected a line " ^ name ^ " ...")

let expect_statement lines statement =
  need (expect ~longest:(String.length statement + 100) lines "the statement" = "statement " ^ statement)
    "the statement is not, word for word, that of this kind"

(* ---- kind theorem2 ---- *)
let theorem2 =
  "For r = 1, every period n in the range and every s in (0, 1/2): if s lies in an open interval of an orbit line \
   then u_n is not 0 and (52) and (53) hold exactly for the listed signs of e*mu and gamma; if s is a listed \
   singular point then u_n = 0, if a listed boundary point then some b_{n,k} = 0 and no two b_{n,k} have opposite \
   signs; at every other s two b_{n,k} have strictly opposite signs or u_n = 0. The orbit lines of each n are \
   exactly the intervals of Theorem 2 (for n = 1 and 2, of the summary by period). Nothing is claimed for r < 1."

let claim n line =
  let fraction word =
    match String.split_on_char '/' word with
    | [ p; q ] ->
        let p = small "a fraction" (2 * n) p and q = small "a fraction" (2 * n) q in
        need (q > 0 && p <= q && prime (whole p) (whole q)) "expected a fraction in lowest terms from 0 to 1";
        (whole p, whole q)
    | _ -> refuse "expected a fraction p/q" in
  let index word =
    let k = small "k" (n - 1) word in
    need (k > 0) "expected k from 1"; whole k in
  let sign = function "+" -> Plus | "-" -> Minus | _ -> refuse "expected + or -" in
  match words line with
  | [ "orbit"; l; h; e; g ] -> Orbit (fraction l, fraction h, sign e, sign g)
  | [ "stretch"; l; h; k; k' ] -> Opposite (fraction l, fraction h, index k, index k')
  | [ "point"; at; "singular" ] -> Singular (fraction at)
  | [ "point"; at; "boundary"; k ] -> Boundary (fraction at, index k)
  | [ "point"; at; "excluded"; k; k' ] -> Excluded (fraction at, index k, index k')
  | _ -> refuse "expected orbit, stretch or point"

let read_theorem2 lines =
  let most = 200_000 in
  let first, last = match words (expect lines "the range") with
    | [ "range"; a; b ] -> (small "a period" most a, small "a period" most b)
    | _ -> refuse "expected a line range ..." in
  need (1 <= first && first <= last) "the range must be 1 <= first <= last";
  let claimed = expect lines "the number of lines" in
  expect_statement lines theorem2;
  let header = lines.number in
  for n = first to last do
    let count = match words (expect lines "a block") with
      | [ "n"; number; count ] ->
          need (small "a period" most number = n) "expected the next period";
          small "the number of lines" 10_000_000 count
      | _ -> refuse "expected a line n ..." in
    let rec claims k = if k = 0 then [] else
      let t = claim n (expect lines "a line of this block") in t :: claims (k - 1) in
    need (blockZ (whole n) (claims count)) (Printf.sprintf "the block of n = %d is not proved" n)
  done;
  need (next lines = None) "the file goes on";
  need (claimed = Printf.sprintf "lines %d" (lines.number - header)) "the number of lines is another"

(* ---- kinds word and word-by-theorem ---- *)
let word =
  "Let (a1, a2) be the listed point or any point of the listed box, u_0 = 0, u_1 = 1, u_{k+1} = a1 u_k - a2 u_{k-1}, \
   b_{n,k} = (u_n - u_k - a2^k u_{n-k})/u_n, p_n = (u_{n+1} - 1)/u_n and q_n = (a2^n + a2 u_{n-1})/u_n. For each \
   listed sign of e mu and every period n from 1 to the last one listed: if n is listed as occurring, then u_n is \
   not 0, every b_{n,k} with 0 < k < n has strictly that sign, and p_n - q_n is > 0 for the letter U and < 0 for D; \
   if not, u_n = 0 or some b_{n,k} has strictly the other sign. For occurring i and j, p_j - q_i is > 0 for the \
   mark + and < 0 for the mark -."
let by_theorem =
  "Let (a1, a2), u, b, p and q be as for certificates of kind word. All points lie in the listed region, and each \
   listed u_n and deciding b_{n,k} has strictly the sign listed, or is 0 where that is listed. If the word theorem \
   holds, as stated and proved in the folder proofs of the project and not here, then for each listed sign of e mu \
   the periods that occur are those listed, and after open perhaps later ones of the path; letters are the signs of \
   p_n - q_n, and p_j - q_i is > 0 for the mark + and < 0 for the mark -."

(* Where a certificate speaks: a box, how many binary digits |a1| has before the point, about, and, for a point given
   by r and s, the least n with u_n = 0. *)
type place = { box : box; digits : int; zero : int option }

(* 2 cos(2 pi s) is guessed between two fractions; [polarZ] decides whether it is there. *)
let polar (r, s) (m, n) =
  if n > 500 then raise (Not_read "a point given by r and s = m/n with a large n");
  let guess = int_of_float (Float.round (Float.ldexp (2. *. cos (2. *. Float.pi *. float m /. float n)) 44)) in
  let near k = (whole (guess + k), whole (1 lsl 44)) in
  match polarZ r s (near (-2)) (near 2) with
  | Some box -> { box; digits = 0; zero = Some (if n mod 2 = 0 then n / 2 else n) }
  | None -> raise (Not_read "a point given by r and s, next to a1 = 2 or -2")
(* u_n = 0 at such a point is not decided by the box. *)
let decided place n =
  match place.zero with
  | Some zero when n mod zero = 0 -> raise (Not_read "u_n = 0 at a point given by r and s")
  | _ -> ()

let read_place line =
  let digits = ref 0 in
  let fraction word =
    match String.split_on_char '/' word with
    | [ p; q ] ->
        let negative = p <> "" && p.[0] = '-' in
        let p = if negative then String.sub p 1 (String.length p - 1) else p in
        let fits x = canonical x && String.length x <= 100 in
        need (fits p && fits q && q <> "0" && not (negative && p = "0")) "expected fractions P/Q";
        digits := max !digits (4 * (String.length p - String.length q + 1));
        let p = large p and q = large q in
        need (prime p q) "expected fractions in lowest terms";
        ((if negative then Z.opp p else p), q)
    | _ -> refuse "expected fractions P/Q" in
  let place box = { box; digits = !digits; zero = None } in
  let place = match words line with
    | [ "at"; "plane"; x; y ] -> let x = fraction x in let y = fraction y in place (((x, x), y), y)
    | [ "at"; "box"; x; x'; y; y' ] ->
        let x = fraction x in let x' = fraction x' in let y = fraction y in let y' = fraction y' in
        place (((x, x'), y), y')
    | [ "at"; "polar"; r; s ] ->
        let r' = fraction r in let s' = fraction s in
        let small word = if String.length word <= 9 then int_of_string word else max_int in
        (match String.split_on_char '/' s with
         | [ m; n ] ->
             let m = small m and n = small n in
             need (m > 0 && m < (n + 1) / 2 && r.[0] <> '-' && r.[0] <> '0') "0 < r <= 1 and 0 < s < 1/2";
             polar (r', s') (m, n)
         | _ -> refuse "expected fractions P/Q")
    | _ -> refuse "expected a line at ..." in
  need (boxZ place.box) "0 < a2 <= 1, and the ends in order";
  place

let marks text =
  List.map (function '+' -> Some Plus | '-' -> Some Minus | '?' -> None | _ -> refuse "expected marks +, - or ?")
    (List.of_seq (String.to_seq text))
(* A line of marks for each of these periods. *)
let rows lines periods =
  List.map (fun i ->
    match words (expect lines "what may follow") with
    | [ "follows"; n; text ] ->
        need (n = string_of_int i) "expected the next period";
        let row = marks text in
        need (List.length row = List.length periods) "expected a mark for each period"; row
    | _ -> refuse "expected a line follows ...") periods

let letter = function "U" -> U | "D" -> D | _ -> refuse "expected the letter U or D"
let period most word = let n = small "a period" most word in need (n > 0) "expected a period"; n

let by_signs lines ({ box; digits; _ } as place) bits e =
  let last = value lines "last" 256 in
  need (last > 0) "the last period is at least 1";
  let rec read n = if n > last then [] else
    let t = match words (expect lines "the next period") with
      | [ "occurs"; k; x ] -> need (period 256 k = n) "the periods come in order"; Occurs (letter x)
      | [ "absent"; k; j ] ->
          need (period 256 k = n) "the periods come in order"; Absent (natural (period (n - 1) j))
      | [ "singular"; k ] -> need (period 256 k = n) "the periods come in order"; decided place n; Vanishes
      | _ -> refuse "expected occurs, absent or singular" in
    t :: read (n + 1) in
  let claims = read 1 in
  let occurs = List.filter (fun n -> match List.nth claims (n - 1) with Occurs _ -> true | _ -> false)
    (List.init last (fun i -> i + 1)) in
  let rows = rows lines occurs in
  need (wordZ (whole (bits + (2 * last * (3 + digits)))) box e claims rows) "the word is not proved"

let path lines ({ box; digits; _ } as place) bits region =
  let first = if region = 4 then 2 else value lines "first" 4096 in
  need (first >= 2) "the first upper period is at least 2";
  decided place (first - 1);
  let told = ref [ first; 1 ] in
  let rec steps i j =
    match words (expect lines "the next step") with
    | [ "open" ] -> ([], Open, i + j)
    | [ name; n; x ] ->
        need (i + j <= 4096 && List.length !told < 512) "too long: end with open";
        need (period 4096 n = i + j) "the mediant has another period";
        (match name, x with
         | "end", "0" -> decided place (i + j); ([], Ends_zero, i + j)
         | "end", x -> ([], Ends (letter x), i + j)
         | "step", x ->
             told := (i + j) :: !told;
             let x = letter x in
             let w, z, last = if x = D then steps (i + j) j else steps i (i + j) in
             (x :: w, z, last)
         | _ -> refuse "expected step, end or open")
    | _ -> refuse "expected step, end or open" in
  let w, z, last = steps 1 first in
  let rows = rows lines (List.rev !told) in
  let last = max last first in
  need (pathZ (whole (bits + (last * (3 + digits)))) box (whole region) (natural first) (natural last) w z rows)
    "the path is not proved"

let by_path lines ({ box; digits; _ } as place) bits region e =
  match region, e with
  | (3 | 4 | 34), Plus -> path lines place bits region
  | (3 | 34), Minus ->
      let n = value lines "below" 512 in
      need (n > 0) "period 1 occurs";
      decided place (n + 1);
      need (belowZ (whole (bits + (n * (3 + digits)))) box (whole region) (natural n)) "the periods are not proved"
  | _ ->
      match lonelyZ box (whole region) e with
      | None -> refuse "nothing is known of this region"
      | Some (all, x) ->
          let line = (if all then "all " else "one ") ^ match x with U -> "U" | D -> "D" in
          need (expect lines "what occurs" = line) ("in this region the line is " ^ line)

let read_words lines statement read =
  expect_statement lines statement;
  let place = read_place (expect lines "a line at ...") in
  let bits = value lines "bits" 4096 in
  need (bits >= 64 && bits mod 32 = 0) "the bits are a multiple of 32 from 64";
  let read = read place bits in
  let rec go seen = match next lines with
    | None -> need (seen <> []) "the file ends where a word should stand"
    | Some "word +" when seen = [] -> read Plus; go [ Plus ]
    | Some "word -" when seen = [] || seen = [ Plus ] -> read Minus; go (Minus :: seen)
    | Some _ -> refuse "expected a line word + or word -, or the end" in
  go []

(* ---- kind chaos 3: the motions and growth, without what the lines reach and complete claim ---- *)
let chaos =
  "For all c, k, f, tau and nu > 0 in the listed ranges, and for g(t) the sum of the listed harmonics a \
   cos jt + b sin jt, a and b in their ranges, all a together 1 and all j b together 0, the oscillator \
   q'' = -c q' - k q + f above the wall sigma nu - 1 + g(t), sigma the listed side, with restitution \
   tau: for every bi-infinite path of the listed graph of letters and every integer m there is exactly \
   one motion whose impacts, one between two letters, have times within W of multiples of 2 pi, as many \
   periods 2 pi apart as the letters say, the impact before letter 0 within W of 2 pi m, and \
   velocities, divided by nu, after the first and before the last impact of each letter in its ranges. \
   It has no other impacts, all are at positive speed, between them the gap is positive, and q/nu stays \
   below the reach. With the same m, paths whose periods differ somewhere have different motions; on \
   the set of the states (q, q') at t = pi of all these motions, for all m, the map to t = 3 pi has a \
   topological entropy between the logarithms of the growth rates. If the line complete has a strength \
   S, every motion that meets the wall at arbitrarily early and arbitrarily late times, and only within \
   W of multiples of 2 pi where |g'| <= nu S/2, is one of these; if c and k are positive, so is every \
   bounded motion for all time that meets it only there."

(* A number below 2^15 in size, of at most 15 digits, as n/d in lowest terms. *)
let quotient p q = { qnum = p; qden = q }
let denominator = function Zpos q -> q | _ -> refuse "expected a denominator from 1"
let limited word =
  need (canonical word && String.length word <= 15) "expected a number of at most 15 digits"; word
let sign word =
  let negative = word <> "" && word.[0] = '-' in
  (negative, if negative then String.sub word 1 (String.length word - 1) else word)
let signed negative p = need (not (negative && p = Z0)) "no -0"; if negative then Z.opp p else p
let below p q = not (qle_bool q p)
let small_enough p = need (below p (quotient (whole 32768) XH)) "a number is 2^15 or more"
let ratio word =
  match String.split_on_char '/' word with
  | [ p; q ] ->
      let negative, p = sign p in
      let p = large (limited p) and q = large (limited q) in
      need (prime p q) "expected a fraction in lowest terms";
      small_enough (quotient p (denominator q));
      quotient (signed negative p) (denominator q)
  | _ -> refuse "expected a fraction P/Q"
let decimal word =
  let negative, size = sign word in
  let whole_part, digits = match String.split_on_char '.' size with
    | [ w ] -> (w, "")
    | [ w; d ] -> need (d <> "" && d.[String.length d - 1] <> '0') "expected no last 0"; (w, d)
    | _ -> refuse "expected a decimal number" in
  need (canonical whole_part && String.length (whole_part ^ digits) <= 15) "expected a decimal number";
  need (String.for_all (fun c -> '0' <= c && c <= '9') digits) "expected a decimal number";
  let p = large (whole_part ^ digits) in
  let q = String.fold_left (fun q _ -> Z.mul ten q) (whole 1) digits in
  small_enough (quotient p (denominator q));
  quotient (signed negative p) (denominator q)
let named lines name = match words (expect ~longest:2000 lines name) with
  | word :: rest when word = name -> rest
  | _ -> refuse ("expected a line " ^ name ^ " ...")
let ends in_order f = function
  | [ a; b ] -> let a = f a in let b = f b in need (in_order a b) "the ends are not in order"; (a, b)
  | _ -> refuse "expected two numbers"
let ratios = ends qle_bool ratio
let decimals = ends below decimal
let one f = function [ a ] -> f a | _ -> refuse "expected one number"
let nothing = quotient Z0 XH
let above_0 q = need (below nothing q) "expected a positive number"; q
let count what least most word = let n = small what most word in need (n >= least) ("too few: " ^ what); n

let range lines name = ratios (named lines name)
let side lines = match named lines "side" with [ "1" ] -> true | [ "-1" ] -> false | _ -> refuse "expected 1 or -1"
let rec times n f = if n = 0 then [] else let x = f () in x :: times (n - 1) f
let rec increasing = function i :: (j :: _ as rest) -> i < j && increasing rest | _ -> true
let harmonics lines =
  let all = times (one (count "harmonics" 1 100) (named lines "harmonics")) (fun () ->
    match named lines "harmonic" with
    | [ n; a; a'; b; b' ] ->
        let n = count "an order" 1 100 n in
        let a = ratios [ a; a' ] in let b = ratios [ b; b' ] in (n, (a, b))
    | _ -> refuse "expected an order and four numbers") in
  need (increasing (List.map fst all)) "the orders increase";
  List.map (fun (n, ranges) -> (positive n, ranges)) all
(* The numbers, from 0, of the letters that may follow. *)
let followers lines number =
  let next = List.map (fun v -> count "a letter" 1 number v) (named lines "next") in
  need (next <> [] && increasing next) "the letters that follow increase";
  List.map (fun v -> v - 1) next

(* The line growth: of each letter its periods, its entry in a vector, and the letters that may follow. *)
let growth lines letters =
  let lo, hi = decimals (named lines "growth") in
  need (qle_bool (quotient (whole 1) XH) lo) "a growth rate is at least 1";
  let all = List.mapi (fun i _ -> i) letters and periods = List.map (fun (n, _, _) -> n) letters in
  let next = List.map (fun (_, _, next) -> next) letters in
  let before = List.map (fun v -> List.filter (fun u -> List.mem v (List.nth next u)) all) all in
  need (List.for_all (fun l -> l <> []) before) "every letter follows some letter";
  let told = List.for_all (fun l ->
    let all = List.map (List.nth periods) l in List.length (List.sort_uniq compare all) = List.length all) in
  need (told next || told before) "paths are not told by their periods";
  let grows way =
    grows (List.map2 (fun n l -> (positive n, List.map natural l)) periods way) (List.map (fun (_, gamma, _) -> gamma) letters) lo hi in
  if not (grows next) then
    if grows before then raise (Not_read "growth by what precedes") else refuse "the growth is not proved"
let at_end lines = need (next lines = None) "the file goes on after its last line"

let read_chaos lines =
  expect_statement lines chaos;
  let range = range lines in
  let damping = range "damping" in let stiffness = range "stiffness" in let force = range "force" in
  if force <> (nothing, nothing) then raise (Not_read "a force");
  let restitution = range "restitution" in let depth = range "depth" in
  let behind = side lines in
  let harmonics = harmonics lines in
  let cells = match named lines "cells" with
    | [ c; k; f; t; n ] ->
        let part = count "parts" 1 10_000 in
        let c = part c in let k = part k in let f = part f in let t = part t in let n = part n in
        if c * k * t * n > 100 || f > 1 then raise (Not_read "more than 100 cells");
        (((natural c, natural k), natural t), natural n)
    | _ -> refuse "expected five numbers" in
  let window = above_0 (one decimal (named lines "window")) in
  ignore (one (count "pieces" 1 1000) (named lines "pieces"));
  let number = one (count "letters" 1 400) (named lines "letters") in
  if number > 20 then raise (Not_read "more than 20 letters");
  let letters = times number (fun () ->
    match named lines "letter" with
    | [ n; a; a'; p; p'; alpha; beta; gamma; parts ] ->
        let n = count "periods" 1 1000 n in
        if n > 30 then raise (Not_read "a letter of more than 30 periods");
        let after = decimals [ a; a' ] in let before = decimals [ p; p' ] in
        let alpha = above_0 (decimal alpha) in let beta = above_0 (decimal beta) in
        let gamma = above_0 (decimal gamma) in
        ignore (count "parts" 1 64 parts);
        ((n, gamma), (positive n, after, before, (alpha, beta)))
    | _ -> refuse "expected a letter") in
  let follow = List.map (fun _ -> followers lines number) letters in
  let graph = List.map2 (fun ((n, gamma), _) next -> (n, gamma, next)) letters follow in
  let letters = List.map2 (fun (_, (periods, after, before, weights)) next ->
    { Letter.periods; after; before; weights; next = List.map natural next }) letters follow in
  let contraction = above_0 (one decimal (named lines "contraction")) in
  ignore (above_0 (one decimal (named lines "reach")));
  growth lines graph;
  let others = match named lines "complete" with
    | [ "no" ] -> ""
    | [ s; longest; parts; rounds ] ->
        ignore (above_0 (decimal s)); ignore (count "periods" 1 1000 longest);
        ignore (count "parts" 1 64 parts); ignore (count "rounds" 1 100 rounds); ", others"
    | _ -> refuse "expected no, or a strength and three numbers" in
  at_end lines;
  let certificate = { Certificate.damping; stiffness; restitution; depth; cells; behind; harmonics; window;
    contraction; letters } in
  need (check certificate) "not proved";
  Some ("reach, entropy" ^ others ^ ": not read")

(* ---- kinds range and range 2: the motions and growth, without continuity, entropy and others ---- *)
let span =
  "For all c, k, tau in the listed ranges, for g(t) the sum of the listed harmonics a cos jt + b sin jt, a \
   and b in their ranges, all a together 1 and all j b together 0, and for every nu > 0 up to the last \
   cell's, the oscillator q'' = -c q' - k q above the wall sigma nu - 1 + g(t), sigma the listed side, with \
   restitution tau: for every bi-infinite path of the listed graph of letters and every integer m there is \
   exactly one motion whose impacts, one between two letters, have times within W of multiples of 2 pi, as \
   many periods 2 pi apart as the letters say, the impact before letter 0 within W of 2 pi m, each at a phase \
   where g' = nu s/2 with s in the range that the cell of nu has for the edge between its letters. It has no \
   other impacts, all are at positive speed, and between them the gap is positive. Where nu is in two cells \
   both have the same motion, and with c, k, tau, g, the path and m held fixed the times and velocities of \
   its impacts depend continuously on nu, from where it is born at nu = 0. With the same m, paths whose \
   periods differ somewhere have different motions; on the set of the states (q, q') at t = pi of all these \
   motions, for all m, the map to t = 3 pi has a topological entropy between the logarithms of the growth \
   rates."
let and_no_others =
  " If a cell has a line others with a strength S, then for its nu every motion that meets the wall at \
   arbitrarily early and late times, only within W of multiples of 2 pi where |g'| <= nu S/2, and is bounded \
   if sigma is -1, is one of these. If c and k are positive, every bounded motion that meets the wall, and \
   only there, is one of these or, if sigma is -1, has a last impact. S is above |s| in the ranges of all its \
   edges."

(* A line others; whether it claims that there are none. *)
let read_others lines = match named lines "others" with
  | [ "no" ] -> false
  | [ s; parts; slices ] ->
      ignore (above_0 (decimal s)); ignore (count "parts" 1 64 parts); ignore (count "slices" 1 1000 slices); true
  | _ -> refuse "expected no, or a strength and two numbers"
let read_edge lines = match named lines "edge" with
  | [ a; b; m; w ] ->
      let strengths = decimals [ a; b ] in let factor = decimal m in
      { Edge.strengths; factor; weight = above_0 (decimal w) }
  | _ -> refuse "expected four numbers"
(* From a depth on, in twice the steps, a hint to the proved function, which narrows less in each than the checker;
   and whether a line others claims that there are none. *)
let read_cell lines second edges first from =
  match named lines "cell" with
  | [ till; parts; steps ] ->
      let till = ratio till in
      let parts = count "parts" 1 64 parts in let steps = count "steps" 0 1000 steps in
      let others = second && read_others lines in
      need (below from till) "the depths of cells increase, from 0";
      need (steps = 0 || not first) "the first cell has no other before it";
      ({ Cell.depth = (from, till); parts = natural parts; steps = natural (2 * steps);
         edges = times edges (fun () -> read_edge lines) }, others)
  | _ -> refuse "expected a depth and two numbers"

let read_range second lines =
  expect_statement lines (if second then span ^ and_no_others else span);
  let damping = range lines "damping" in let stiffness = range lines "stiffness" in
  let restitution = range lines "restitution" in
  need (below nothing (fst restitution)) "a restitution is positive";
  let behind = side lines in let harmonics = harmonics lines in
  let window = above_0 (one decimal (named lines "window")) in
  ignore (one (count "pieces" 1 1000) (named lines "pieces"));
  let number = one (count "letters" 1 400) (named lines "letters") in
  if number > 20 then raise (Not_read "more than 20 letters");
  let letters = times number (fun () ->
    match named lines "letter" with
    | [ n; gamma ] ->
        let n = count "periods" 1 1000 n in
        if n > 30 then raise (Not_read "a letter of more than 30 periods");
        (n, above_0 (decimal gamma))
    | _ -> refuse "expected the periods and a number") in
  let letters = List.map (fun (n, gamma) -> (n, gamma, followers lines number)) letters in
  let graph = List.concat (List.mapi (fun u (_, _, next) -> List.map (fun v -> (u, v)) next) letters) in
  let periods = List.map (fun (n, _, _) -> positive n) letters in
  growth lines letters;
  let contraction = above_0 (one decimal (named lines "contraction")) in
  need (below contraction (quotient (whole 1) XH)) "a contraction is below 1";
  if second then begin
    ignore (one (count "periods" 1 100) (named lines "longest"));
    ignore (one (count "rounds" 1 100) (named lines "rounds"))
  end;
  let cells = one (count "cells" 1 10_000) (named lines "cells") in
  let edges = List.length graph in
  need (cells * edges <= 100_000) "too many lines edge";
  let rec read_cells n from =
    if n = 0 then [] else
      let (cell, _) as all = read_cell lines second edges (n = cells) from in
      all :: read_cells (n - 1) (snd cell.Cell.depth) in
  let all = read_cells cells nothing in
  at_end lines;
  let certificate = { Range.damping; stiffness; restitution; behind; harmonics; window; contraction; periods;
    graph = List.map (fun (u, v) -> (natural u, natural v)) graph; cells = List.map fst all } in
  need (check_range certificate) "not proved";
  Some ("continuity, entropy" ^ (if List.exists snd all then ", others" else "") ^ ": not read")

(* ---- kind attractor ---- *)
let attractor =
  "For all c, k, tau in the listed ranges, for g(t) the sum of the listed harmonics a cos jt + b sin jt, a and b \
   in their ranges, all a together 1 and all j b together 0, and for every nu > 0 up to the listed depth, consider \
   the motions of the oscillator q'' = -c q' - k q above the wall Q(t) = nu - 1 + g(t) with restitution tau: q is \
   never below the wall, free where it is above, and where it meets the wall it leaves at tau times the speed at \
   which it comes. Let a < b be the roots of z^2 - c z + k, which are real and positive, and V = q' - Q' before a \
   contact, which is a graze if V = 0. With the listed speed S, slip Z, growth E and start X let D be the contacts \
   at which Q >= 0, -S sqrt(nu) <= V <= 0 and 0 <= a Q + Q' + V <= Z nu. Then after a contact in D the motion is \
   free for a time, until a next contact, which is in D. Every motion that begins at a time at which Q <= 0, with \
   q >= 0 and 0 <= a q + q' <= X, is in D from its third contact on. Small displacements of q and q' at a fixed \
   time, just before a contact in D that is no graze, for which neither that of q nor that of a q + q' is below 0, \
   become, but for their sign, such displacements just before the next contact, and that of q grows E-fold at \
   least. No periodic motion whose contacts are in D, grazing or not, is stable in Lyapunov's sense. Every motion \
   whose contacts are in D and no grazes has a positive Lyapunov exponent; where an exponent R is listed with a \
   nu, from that nu on it is at least R in each period 2 pi. Of the motions that begin as said almost all never \
   graze. It is not said that there is one attractor, that a motion comes near all of it, or how long it is where."

let is_cosine = function
  | [ (XH, ((a, a'), (b, b'))) ] ->
      let one = quotient (whole 1) XH in a = one && a' = one && b = nothing && b' = nothing
  | _ -> false
let read_attractor lines =
  expect_statement lines attractor;
  let damping = range lines "damping" in let stiffness = range lines "stiffness" in
  let restitution = range lines "restitution" in
  ignore (above_0 (fst restitution));
  let harmonics = harmonics lines in
  let depth = above_0 (one ratio (named lines "depth")) in
  let two name = match named lines name with
    | [ u; v ] -> let u = above_0 (decimal u) in let v = above_0 (decimal v) in (u, v)
    | _ -> refuse "expected two numbers" in
  let window = two "window" in let bends = two "bends" in
  let concave = if is_cosine harmonics then None else begin
    let concave = two "concave" in
    ignore (one (count "pieces" 1 1000) (named lines "pieces"));
    Some concave end in
  let speed = above_0 (one decimal (named lines "speed")) in let slip = above_0 (one decimal (named lines "slip")) in
  let growth, last = match named lines "growth" with
    | [ e; n ] -> let e = above_0 (decimal e) in (e, count "periods" 1 1000 n)
    | _ -> refuse "expected a growth and a number of periods" in
  need (below (quotient (whole 1) XH) growth) "a growth must be above 1";
  let start = above_0 (one decimal (named lines "start")) in
  let exponent = match named lines "exponent" with
    | [ "none" ] -> None
    | [ nu; r; l ] ->
        let nu = above_0 (ratio nu) in let rate = above_0 (decimal r) in let most = count "periods" 1 2000 l in
        need (qle_bool nu depth) "an exponent is listed from a depth up to the greatest";
        Some ((nu, rate), positive most)
    | _ -> refuse "expected none, or a depth, a rate and a number of periods" in
  at_end lines;
  need (check_trap { Trap.damping; stiffness; restitution; harmonics; depth; window; bends; concave; speed; slip; growth;
    last = positive last; start; exponent }) "not proved";
  None

let read_signs lines = function
  | "kind theorem2" -> read_theorem2 lines
  | "kind word" -> read_words lines word (by_signs lines)
  | "kind word-by-theorem" ->
      read_words lines by_theorem (fun place bits ->
        let region = value lines "region" 34 in
        need (regionZ place.box (whole region)) "not all of the set lies in this region";
        by_path lines place bits region)
  | _ -> raise (Not_read "a kind that is not theorem2, word, word-by-theorem, chaos 3, range or attractor")

(* What is proved; and what of it is not read. *)
let read lines =
  need (expect lines "the format" = "grazing-certificate 1") "no certificate of this format";
  match expect lines "the kind" with
  | "kind chaos 3" -> read_chaos lines
  | "kind range" -> read_range false lines
  | "kind range 2" -> read_range true lines
  | "kind attractor" -> read_attractor lines
  | kind -> read_signs lines kind; None

let text_of file =
  let channel = open_in_bin file in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel; text

let () =
  let files = match List.tl (Array.to_list Sys.argv) with "--" :: files -> files | files -> files in
  List.iter (fun file ->
    let lines = lines_of (text_of file) in
    print_endline (match read lines with
      | None -> "proved"
      | Some rest -> "proved; " ^ rest
      | exception Refused reason -> Printf.sprintf "refused: line %d: %s" lines.number reason
      | exception Not_read what -> "not read: " ^ what)) files
