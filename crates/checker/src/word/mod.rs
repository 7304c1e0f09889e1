//! Certificates of kinds `word` and `word-by-theorem`: every impact pattern at a point, or at all points of a
//! box, of the plane of (a₁, a₂).
//!
//! With u_0 = 0, u_1 = 1, u_{k+1} = a₁u_k − a₂u_{k−1} and N_{n,k} = u_n − u_k − a₂ᵏ u_{n−k}, (59) is b_{n,k}
//! = N_{n,k}/u_n. A period n can occur between impacts, for a sign of eµ, if u_n ≠ 0 and all b_{n,k} have
//! that sign; its letter is U for c_n > 0, D for c_n < 0. Period j may follow i if sign(eµ) sign(γ) (p_j −
//! q_i) > 0, (64). From u_{i+j} = u_i u_{j+1} − a₂ u_{i−1} u_j it follows that p_j − q_i = N_{i+j,i}/(u_i
//! u_j) and c_n = N_{2n,n}/u_n². So signs of u and of N are all that is proved (`set`), on every point of the
//! set at once.
//!
//! - `word` takes nothing from the word theorem: it proves for every period from 1 to N that it occurs, by
//!   all its b, or does not, by one b or by u_n = 0; and every edge and every missing edge by the sign of its
//!   own p_j − q_i.
//! - `word-by-theorem` proves what the word theorem asks for, one u and one b per step of the Stern–Brocot
//!   path, and prints what it gives: all periods, without end, and all edges. It is as good as that theorem,
//!   which is proved for readers and for Coq in the folder `proofs`.
//!
//! # Form
//!
//! ```text
//! statement …                     what passing proves, word for word: STATEMENT or STATEMENT_BY_THEOREM
//! at plane A1 A2                  the set: a point (a₁, a₂); or
//! at polar R S                    the point a₁ = 2r cos 2πs, a₂ = r², 0 < r ≤ 1, 0 < s < ½; or
//! at box LO HI LO HI              all points with a₁ and a₂ in these closed intervals
//! bits P                          the precision of the check, a multiple of 32 from 64 to 4096
//! word +                          for eµ > 0 (+), or eµ < 0 (-): the lines below; then perhaps the other, +
//!                                 before -
//! ```
//!
//! A1, A2, R, S, LO, HI are fractions `-?P/Q` in lowest terms, Q > 0, of at most 100 digits each; 0 < a₂ ≤ 1.
//! In kind `word` follow
//!
//! ```text
//! last N                          1 ≤ N ≤ 256
//! occurs n L                      for each n = 1, …, N one of these three: all b_{n,k} have the sign of eµ,
//!                                 c_n that of the letter L, U or D
//! absent n K                      b_{n,K} has the other sign
//! singular n                      u_n = 0 (at a single point)
//! follows i MARKS                 for each i that occurs, a mark for each j that occurs: + p_j > q_i, - p_j
//!                                 < q_i, ? nothing is claimed
//! ```
//!
//! In kind `word-by-theorem` a line `region R` comes after `bits P`, the paper's region, 1 to 5, that the set
//! lies in, or 34 for regions 3 and 4 together: −(a₂+1) < a₁ < 2√a₂. There the lines are those of region 3,
//! since the theorem makes no difference between the two. Then for each word
//!
//! ```text
//! all L                           regions 1 and 5 for +, 2 for -: every period occurs, with this letter (U
//!                                 in region 1, else D)
//! one L                           regions 2 for +, 1, 4 and 5 for -: period 1 alone
//! below H                         region 3 for -: the periods 1, …, H, H ≤ 512: u_1, …, u_H > 0 and u_{H+1}
//!                                 < 0 or = 0
//! first K                         region 3 for +: u_1, …, u_{K−1} > 0 (the last one may be 0), u_K < 0, K ≤
//!                                 4096; 1 is D and K is U. In region 4 K = 2 without this line
//! step n L                        the next period on the path occurs: n = i + j for the last D, i, and the
//!                                 last U, j; u_n < 0 and b_{n,j} > 0 (U), u_n > 0 and b_{n,i} > 0 (D)
//! end n L                         it does not: u_n < 0 and b_{n,j} < 0 (U), u_n > 0 and b_{n,i} < 0 (D); or
//! end n 0                         u_n = 0; or
//! open                            nothing is claimed of it
//! follows i MARKS                 after first or region 4: a line for each letter in path order, as the
//!                                 theorem has it; at most 512 letters, n ≤ 4096
//! ```
//!
//! The marks by the theorem: U to U +, D to D -; between a D, i, and a U, j: the last pair + from D to U, -
//! from U to D (both ? after `open`, and after `end n 0` with a₂ = 1); else, if m_j n_i − m_i n_j = 1, both +
//! or both - as the letter of i + j is U or D; else both + or both - as the later of the two is D or U.
//!
//! # Cost
//!
//! A sign of index n takes about 8 (P/32 + 1)((P + n log₂ ρ)/32 + 1) products of two 32-bit digits (`set` has
//! ρ, 1 for |a₁| ≤ 1 + a₂); a check that would take more than 4·10⁹ in all is refused before the part that
//! exceeds it, so that none takes more than some ten seconds. Memory: 3N numbers of P + N log₂ ρ bits.
//!
//! # Two certificates by hand
//!
//! ```text
//! at plane -1/4 1/2
//! bits 64
//! word +
//! last 4
//! occurs 1 D
//! occurs 2 U
//! occurs 3 U
//! absent 4 1
//! follows 1 -++
//! follows 2 +++
//! follows 3 -++
//! ```
//!
//! u = 0, 1, −1/4, −7/16, 15/64, 41/256, −161/1024. Period 2: N_{2,1} = u_2 − u_1 − a₂u_1 = −7/4, so b_{2,1}
//! = 7 > 0. Period 3: N_{3,1} = u_3 − u_1 − a₂u_2 = −21/16 and N_{3,2} = u_3 − u_2 − a₂²u_1 = −7/16, both b >
//! 0 as u_3 < 0; N_{6,3} = u_6 − u_3 − a₂³u_3 = 343/1024 > 0, so its letter is U. Period 4: N_{4,1} = u_4 −
//! u_1 − a₂u_3 = −35/64 and u_4 > 0, so b_{4,1} < 0: absent. From 1 to 3: p_3 − q_1 = N_{4,1}/(u_1u_3) =
//! 5/4 > 0, the last mark of the row `follows 1`; from 3 to 1: N_{4,3} = 35/64, p_1 − q_3 = −5/4 < 0, the
//! first of `follows 3`. The same by the theorem, from u_2, u_3, N_{3,2}, u_4 and N_{4,1} alone:
//!
//! ```text
//! at plane -1/4 1/2
//! bits 64
//! region 3
//! word +
//! first 2
//! step 3 U
//! end 4 D
//! follows 1 -++
//! follows 2 +++
//! follows 3 -++
//! ```
//!
//! Damage is found:
//!
//! - `absent 4 1` to `absent 4 2`: `line 11: false: b_{4,2} is not certainly < 0`;
//! - `follows 3 -++` to `follows 3 +++` in the first: `line 14: false: p_1 - q_3 is not certainly > 0`; in
//!   the second: `line 13: false: by the theorem this line is "follows 3 -++"`;
//! - `-1/4` to `-1/2` in the first: `line 10: false: b_{3,2} is not certainly > 0`, for there N_{3,2} = 0.

mod by_signs;
mod by_theorem;
pub(crate) mod integer;
pub(crate) mod number;
pub(crate) mod set;
mod text;

use super::Rejection;

pub(super) use by_signs::check;
pub(super) use by_theorem::check as check_by_theorem;

/// The word in the header, by signs alone.
pub const KIND: &str = "word";

/// The same, by the word theorem.
pub const KIND_BY_THEOREM: &str = "word-by-theorem";

/// The largest period that a certificate of kind `word` decides.
pub const MOST: u64 = 256;

/// The largest period that one of kind `word-by-theorem` comes to.
pub const LONGEST: u64 = 4096;

/// The number that stands for regions 3 and 4 together.
pub const BETWEEN: u64 = 34;

/// The most letters of one of kind `word-by-theorem`.
pub const LETTERS: u64 = 512;

/// What a certificate of kind `word` proves.
pub const STATEMENT: &str = "Let (a1, a2) be the listed point or any point of the listed box, u_0 = 0, u_1 = 1, \
u_{k+1} = a1 u_k - a2 u_{k-1}, b_{n,k} = (u_n - u_k - a2^k u_{n-k})/u_n, p_n = (u_{n+1} - 1)/u_n and \
q_n = (a2^n + a2 u_{n-1})/u_n. For each listed sign of e mu and every period n from 1 to the last one listed: if n is \
listed as occurring, then u_n is not 0, every b_{n,k} with 0 < k < n has strictly that sign, and p_n - q_n is > 0 for \
the letter U and < 0 for D; if not, u_n = 0 or some b_{n,k} has strictly the other sign. For occurring i and j, \
p_j - q_i is > 0 for the mark + and < 0 for the mark -.";

/// What a certificate of kind `word-by-theorem` proves.
pub const STATEMENT_BY_THEOREM: &str = "Let (a1, a2), u, b, p and q be as for certificates of kind word. All points lie in \
the listed region, and each listed u_n and deciding b_{n,k} has strictly the sign listed, or is 0 where that is listed. \
If the word theorem holds, as stated and proved in the folder proofs of the project and not here, then for each \
listed sign of e mu the periods that occur are those listed, and after open perhaps later ones of the path; letters are the \
signs of p_n - q_n, and p_j - q_i is > 0 for the mark + and < 0 for the mark -.";
