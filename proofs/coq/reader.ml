(* A reader of certificates of kinds theorem2, word and word-by-theorem: one answer per file named on the command line,
   "proved", "refused: line N: ..." or "not read: ...". What a file claims is decided by the proved functions of
   StatementReaders.v and StatementReaderWords.v; here files are cut into lines and words, numbers are read, and the
   form is checked, as the heads of checker/src/theorem2/mod.rs and checker/src/word/mod.rs have it. *)
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
  let all = String.split_on_char '\n' text in
  let rec ends = function
    | [] | [ "" ] -> []
    (* A last line without its end keeps a carriage return. *)
    | [ line ] -> [ line ]
    | line :: rest ->
        let n = String.length line in
        (if n > 0 && line.[n - 1] = '\r' then String.sub line 0 (n - 1) else line) :: ends rest in
  { rest = ends all; number = 0 }

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

let read lines =
  need (expect lines "the format" = "grazing-certificate 1") "no certificate of this format";
  match expect lines "the kind" with
  | "kind theorem2" -> read_theorem2 lines
  | "kind word" -> read_words lines word (by_signs lines)
  | "kind word-by-theorem" ->
      read_words lines by_theorem (fun place bits ->
        let region = value lines "region" 34 in
        need (regionZ place.box (whole region)) "not all of the set lies in this region";
        by_path lines place bits region)
  | _ -> raise (Not_read "a kind that is not theorem2, word or word-by-theorem")

let text_of file =
  let channel = open_in_bin file in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel; text

let () =
  for i = 1 to Array.length Sys.argv - 1 do
    let lines = lines_of (text_of Sys.argv.(i)) in
    print_endline (match read lines with
      | () -> "proved"
      | exception Refused reason -> Printf.sprintf "refused: line %d: %s" lines.number reason
      | exception Not_read what -> "not read: " ^ what)
  done
