(* The proved functions of StatementZ.v and StatementCircleZ.v on a list of questions, one a line; only reading and printing happen here.
   Numbers are decimal; a1 = p/q, a2 = s/q. Each answer is the question and what follows a blank:
   "p s q n": whether u_n = 0 (0 or 1), the signs of b_{n,1} .. b_{n,n-1} as letters -, 0, + (a dot where there are
   none), those of c_n and of 1 - v_n + a2^n, existence in the cases (+,+), (+,-), (-,+), (-,-) as 0 or 1, and
   whether two b have opposite signs.
   "word p s q N": which of 1 .. N are members of V for e mu > 0, and for e mu < 0; then the signs of p_j - q_i, a row
   per i <= N of letters for j <= N, a dot where u_i or u_j = 0.
   "pattern p s q n1,n2,..": whether the pattern exists in the four cases.
   "list n": Theorem 2's intervals but the first, each as k, the sign of gamma and its ends: "3+1/8,1/4".
   "circle n x z": at s = x/z on r = 1, whether u_n = 0, existence in the four cases, and whether Theorem 2 says that
   nothing exists. *)
open Decide

let rec positive k = if k = 1 then XH else if k land 1 = 1 then XI (positive (k / 2)) else XO (positive (k / 2))
let small k = if k = 0 then Z0 else Zpos (positive k)
let ten = small 10

let integer word =
  let negative = word.[0] = '-' in
  let digits = if negative then String.sub word 1 (String.length word - 1) else word in
  let value = ref Z0 in
  String.iter (fun d -> value := Z.add (Z.mul ten !value) (small (Char.code d - Char.code '0'))) digits;
  if negative then Z.opp !value else !value

let rec natural k = if k = 0 then O else S (natural (k - 1))
let letter = function Z0 -> '0' | Zpos _ -> '+' | Zneg _ -> '-'
let bit b = if b then '1' else '0'

let cases = [ (Plus, Plus); (Plus, Minus); (Minus, Plus); (Minus, Minus) ]
let bits list = String.of_seq (List.to_seq (List.map bit list))
let rec coq = function [] -> [] | n :: l -> natural (int_of_string n) :: coq l


let rec number = function XH -> 1 | XO p -> 2 * number p | XI p -> (2 * number p) + 1
let decimal = function Z0 -> 0 | Zpos p -> number p | Zneg p -> -number p
let sign = function Plus -> '+' | Minus -> '-'
let sides = Hashtbl.create 200
let list n =
  match Hashtbl.find_opt sides n with
  | Some l -> l
  | None -> let l = sidesZ (small n) in Hashtbl.add sides n l; l

let answer line =
  match String.split_on_char ' ' line with
  | [ "list"; n ] ->
      let piece (((k, g), (l1, l2)), (h1, h2)) =
        Printf.sprintf "%d%c%d/%d,%d/%d" (decimal k) (sign g) (decimal l1) (decimal l2) (decimal h1) (decimal h2) in
      String.concat " " (List.map piece (list (int_of_string n)))
  | [ "circle"; n; x; z ] ->
      let n = int_of_string n and x = integer x and z = integer z in
      let l = list n and n = small n in
      Printf.sprintf "%c %s %c"
        (bit (singularZ n x z))
        (bits (List.map (fun (e, g) -> circleZ n l x z e g) cases))
        (bit (no_circleZ n l x z))
  | [ "word"; p; s; q; n ] ->
      let p = integer p and s = integer s and q = integer q and n = int_of_string n in
      let all = List.init n (fun i -> natural (i + 1)) in
      let zero i = uZ p s q i = Z0 in
      let sign i j = if zero i || zero j then '.' else letter (signE p s q i j) in
      let row i = String.of_seq (List.to_seq (List.map (sign i) all)) in
      String.concat " "
        (bits (List.map (memberZ p s q Plus) all) :: bits (List.map (memberZ p s q Minus) all) :: List.map row all)
  | [ "pattern"; p; s; q; l ] ->
      let p = integer p and s = integer s and q = integer q and l = coq (String.split_on_char ',' l) in
      bits (List.map (fun (e, g) -> patternZ p s q e g l) cases)
  | [ p; s; q; n ] ->
      let p = integer p and s = integer s and q = integer q and n = int_of_string n in
      let nn = natural n in
      let b = String.init (n - 1) (fun i -> letter (signB p s q nn (natural (i + 1)))) in
      Printf.sprintf "%c %s %c %c %s %c"
        (bit (uZ p s q nn = Z0))
        (if b = "" then "." else b)
        (letter (signC p s q nn))
        (letter (signD p s q nn))
        (bits (List.map (fun (e, g) -> orbitZ p s q nn e g) cases))
        (bit (no_orbitZ p s q nn))
  | _ -> failwith ("not a question: " ^ line)

let () =
  try
    while true do
      let line = input_line stdin in
      Printf.printf "%s %s\n" line (answer line)
    done
  with End_of_file -> ()
