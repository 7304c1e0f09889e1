(* The proved functions of StatementZ.v on a list of points. Each input line is "p s q n", decimal, for
   a1 = p/q, a2 = s/q and the period n; each output line is "p s q n U B C D E O": whether u_n = 0 (0 or 1),
   the signs of b_{n,1} .. b_{n,n-1} as letters -, 0, + (a dot where there are none), those of c_n and of
   1 - v_n + a2^n, existence in the cases (+,+), (+,-), (-,+), (-,-) as 0 or 1, and whether two b have
   opposite signs. Only reading and printing happen here. *)
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

let () =
  try
    while true do
      let line = input_line stdin in
      match String.split_on_char ' ' line with
      | [ p; s; q; n ] ->
          let p = integer p and s = integer s and q = integer q and n = int_of_string n in
          let nn = natural n in
          let b = String.init (n - 1) (fun i -> letter (signB p s q nn (natural (i + 1)))) in
          let cases = String.of_seq (List.to_seq (List.map bit (all_cases p s q nn))) in
          Printf.printf "%s %c %s %c %c %s %c\n" line
            (bit (uZ p s q nn = Z0))
            (if b = "" then "." else b)
            (letter (signC p s q nn))
            (letter (signD p s q nn))
            cases
            (bit (no_orbitZ p s q nn))
      | _ -> failwith ("not a point: " ^ line)
    done
  with End_of_file -> ()
