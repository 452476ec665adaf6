
Import ListNotations.

(* ---------------------------------------------------------------------------------------------- *)
(* Evidence: polynomials with integer coefficients, sums of cofactors times polynomials, and the   *)
(* cases of a statement that they exclude. All of it is computed; [judged] says what that proves.  *)
(* ---------------------------------------------------------------------------------------------- *)

Notation polynomial := (Pol Z).
Notation text := (PExpr Z).
Definition X (n : positive) : text := PEX Z n.
Definition C (c : Z) : text := PEc c.
Declare Scope text_scope.
Delimit Scope text_scope with text.
Notation "f + g" := (PEadd f g) : text_scope.
Notation "f - g" := (PEsub f g) : text_scope.
Notation "f * g" := (PEmul f g) : text_scope.
Notation "- f" := (PEopp f) : text_scope.
Notation "f ^ n" := (PEpow f n%N) : text_scope.
Definition padd : polynomial -> polynomial -> polynomial := Padd 0%Z Z.add Zeq_bool.
Definition psub : polynomial -> polynomial -> polynomial := Psub 0%Z Z.add Z.sub Z.opp Zeq_bool.
Definition pmul : polynomial -> polynomial -> polynomial := Pmul 0%Z 1%Z Z.add Z.mul Zeq_bool.
Definition popp : polynomial -> polynomial := Popp Z.opp.
Definition variable (n : positive) : polynomial := mk_X 0%Z 1%Z n.
Definition read : text -> polynomial := norm_aux 0%Z 1%Z Z.add Z.mul Z.sub Z.opp Zeq_bool.

(* A proof that some polynomials cannot all be 0 while others are not. [T1], [T2], ... are the
   inverses of the latter. *)
Inductive steps :=
  | Contradiction (cofactors : list text) (denominator : Z)
  | Norm_is_zero (terms : quaternion text) (cofactors : list text) (rest : steps)
  | Squares_are_zero (terms : list (Z * text)) (cofactors : list text) (rest : steps)
  | Cases (factors : list (text * nat)) (cofactors : list text) (denominator : Z)
          (branches : list steps).
Inductive item :=
  | Direct (zeros : list text) (member : text) (cofactors : list text) (denominator : Z)
  | Excluded (zeros nonzeros : list text) (script : steps).
Record evidence := Evidence {
  items : list item;
  numbers : list Z;  (* that are divided by *)
  stripped : list (text * list text * text);  (* f = number * product * g *)
  vanishing : list (text * list text) }.  (* f = sum of cofactors times what is 0 in the field *)

(* What is known of the numbers: [modulus] is 0, [units] are invertible, all but 0 are if [rational]. *)
Record knowledge := Knowledge {
  modulus : Z; units : list Z; rational : bool; divides : bool;
  norm_known : bool; squares_known : bool; relations : list text }.

Section Computed.
Variable known : knowledge.
Definition residue (c : Z) : Z := if Z.eqb (modulus known) 0 then c else Z.modulo c (modulus known).
Fixpoint reduced (f : polynomial) : polynomial :=
  match f with
  | Pc c => Pc (residue c)
  | Pinj n g => mkPinj n (reduced g)
  | PX g n h => mkPX 0%Z Zeq_bool (reduced g) n (reduced h)
  end.
Definition modulo f := if Z.eqb (modulus known) 0 then f else reduced f.
Fixpoint is_zero (f : polynomial) : bool :=
  match f with
  | Pc c => Z.eqb (residue c) 0
  | Pinj _ g => is_zero g
  | PX g _ h => is_zero g && is_zero h
  end.
Fixpoint divided (fuel : nat) (c : Z) : Z :=
  match fuel with
  | O => c
  | S fuel =>
      match List.find (fun u => Z.eqb c (u * Z.div c u)) (units known) with
      | Some u => divided fuel (Z.div c u)
      | None => c
      end
  end.
Definition number_is_unit (c : Z) : bool :=
  if rational known then negb (Z.eqb c 0)
  else Z.eqb (Z.gcd (divided (S (Z.to_nat (Z.log2 (Z.abs c)))) c) (modulus known)) 1.
Fixpoint lead (f : polynomial) : Z :=
  match f with Pc c => c | Pinj _ g => lead g | PX g _ _ => lead g end.
Definition times (c : Z) (f : polynomial) := pmul (Pc c) f.
Definition proportional (f g : polynomial) : bool :=
  let f := modulo f in let g := modulo g in
  is_zero (psub f g) || is_zero (padd f g) ||
  (let a := lead g in let b := lead f in
   number_is_unit a && number_is_unit b && is_zero (psub (times a f) (times b g))).

(* Fractions whose denominators are products of [factors]. *)
Record fraction := Fraction { valid : bool; top : polynomial; below : list nat }.
Fixpoint power (f : polynomial) (n : nat) : polynomial :=
  match n with O => Pc 1%Z | S m => pmul f (power f m) end.
Fixpoint product (factors : list polynomial) (exponents : list nat) : polynomial :=
  match factors, exponents with
  | List.cons f fs, List.cons n ns => pmul (power f n) (product fs ns)
  | _, _ => Pc 1%Z
  end.
Fixpoint joined (op : nat -> nat -> nat) (ms ns : list nat) : list nat :=
  match ms, ns with
  | List.nil, _ => List.map (op O) ns
  | _, List.nil => List.map (fun m => op m O) ms
  | List.cons m ms, List.cons n ns => List.cons (op m n) (joined op ms ns)
  end.
Definition made v f (ns : list nat) : fraction :=
  let f := modulo f in Fraction v f (if is_zero f then List.nil else ns).
Definition polynomial_fraction f := Fraction true f List.nil.
Fixpoint position (f : polynomial) (factors : list polynomial) : option (list nat) :=
  match factors with
  | List.nil => None
  | List.cons g rest =>
      if is_zero (psub f g) then Some (List.cons 1%nat List.nil)
      else match position f rest with Some ns => Some (List.cons O ns) | None => None end
  end.

Section Fractions.
Variable factors : list polynomial.
Definition fraction_sum (op : polynomial -> polynomial -> polynomial) (x y : fraction) : fraction :=
  let ns := joined Nat.max (below x) (below y) in
  made (valid x && valid y)
    (op (pmul (top x) (product factors (joined Nat.sub ns (below x))))
        (pmul (top y) (product factors (joined Nat.sub ns (below y))))) ns.
Definition fractions : Operations fraction := {|
  zero := polynomial_fraction (Pc 0%Z); one := polynomial_fraction (Pc 1%Z);
  add := fraction_sum padd; sub := fraction_sum psub;
  mul := fun x y => made (valid x && valid y) (pmul (top x) (top y)) (joined Nat.add (below x) (below y));
  opp := fun x => Fraction (valid x) (popp (top x)) (below x) |}.
Definition reciprocal : Inverse fraction := fun x =>
  let above := product factors (below x) in
  if is_zero (psub (top x) (Pc 1%Z)) then Fraction (valid x && divides known) above List.nil
  else match position (top x) factors with
  | Some ns => Fraction (valid x && divides known) above ns
  | None => Fraction false above List.nil
  end.
End Fractions.
Fixpoint quaternion_symbols (n : nat) : list (quaternion polynomial) :=
  match n with
  | O => List.nil
  | S n => List.cons (Quaternion (variable 1) (variable 2) (variable 3) (variable 4))
      (List.map (fun q => Quaternion (mkPinj 4 (re q)) (mkPinj 4 (im q)) (mkPinj 4 (jm q)) (mkPinj 4 (km q)))
         (quaternion_symbols n))
  end.
Fixpoint scalar_symbols (n : nat) : list polynomial :=
  match n with
  | O => List.nil
  | S n => List.cons (variable 1) (List.map (mkPinj 1) (scalar_symbols n))
  end.
Fixpoint after (n : nat) (f : polynomial) : polynomial :=
  match n with O => f | S m => mkPinj 1 (after m f) end.
Definition as_fractions (q : quaternion polynomial) :=
  Quaternion (polynomial_fraction (re q)) (polynomial_fraction (im q))
             (polynomial_fraction (jm q)) (polynomial_fraction (km q)).

(* Sums of cofactors times polynomials. *)
Fixpoint sum_of (cofactors : list text) (fs : list polynomial) : polynomial :=
  match cofactors, fs with
  | List.cons c cs, List.cons f fs => padd (pmul (read c) f) (sum_of cs fs)
  | _, _ => Pc 0%Z
  end.
Definition is_multiple (sum : polynomial) (d : Z) (f : polynomial) : bool :=
  number_is_unit d && is_zero (psub sum (times d f)).
Variable form : polynomial -> polynomial -> polynomial -> polynomial -> fraction.
Fixpoint run (s : steps) (zeros : list polynomial) {struct s} : bool :=
  match s with
  | Contradiction cs d => is_multiple (sum_of cs zeros) d (Pc 1%Z)
  | Norm_is_zero (Quaternion a b c d) cs rest =>
      let (a, b, c, d) := Quaternion (read a) (read b) (read c) (read d) in
      norm_known known && valid (form a b c d) &&
      proportional (sum_of cs zeros) (top (form a b c d)) &&
      run rest (zeros ++ List.cons a (List.cons b (List.cons c (List.cons d List.nil))))
  | Squares_are_zero terms cs rest =>
      let fs := List.map (fun t => (fst t, read (snd t))) terms in
      squares_known known && forallb (fun t => Z.ltb 0 (fst t)) fs &&
      proportional (sum_of cs zeros)
        (fold_right (fun t f => padd (times (fst t) (pmul (snd t) (snd t))) f) (Pc 0%Z) fs) &&
      run rest (zeros ++ List.map snd fs)
  | Cases factors cs d branches =>
      let fs := List.map (fun t => (read (fst t), snd t)) factors in
      is_multiple (sum_of cs zeros) d
        (fold_right (fun t f => pmul (power (fst t) (snd t)) f) (Pc 1%Z) fs) &&
      Nat.eqb (length fs) (length branches) &&
      (fix each fs branches {struct branches} := match fs, branches with
       | List.cons f fs, List.cons s branches =>
           run s (zeros ++ List.cons (fst f) List.nil) && each fs branches
       | _, _ => true
       end) fs branches
  end.
Fixpoint inverses (n : nat) : list polynomial :=
  match n with O => List.nil | S m => List.cons (variable 1) (List.map (mkPinj 1) (inverses m)) end.
Definition is_sound (i : item) : bool :=
  match i with
  | Direct zeros f cs d => is_multiple (sum_of cs (List.map read zeros)) d (read f)
  | Excluded zeros nonzeros script =>
      let n := length nonzeros in
      run script (List.map (fun f => after n (read f)) zeros ++
        List.map (fun p => psub (Pc 1%Z) (pmul (fst p) (after n (read (snd p)))))
          (combine (inverses n) nonzeros))
  end.

(* What is 0, and what is not, at some place of a statement. *)
Variable shown : evidence.
Definition vanishes (f : polynomial) : bool :=
  is_zero f || existsb (fun t => proportional (read (fst t)) f &&
    is_zero (psub (read (fst t)) (sum_of (snd t) (List.map read (relations known))))) (vanishing shown).
Definition strips (t : text * list text * text) : bool :=
  let '(f, ds, g) := t in
  proportional (read f) (fold_right (fun d h => pmul (read d) h) (read g) ds).
Section Place.
Variables zs ns : list polynomial.
Definition plainly_zero f := vanishes f || existsb (fun z => proportional z f) zs.
Definition plainly_nonzero f := existsb (fun z => proportional z f) ns.
Definition hints := List.filter strips (stripped shown).
Definition zero_by_hint (f : polynomial) : bool :=
  plainly_zero f || existsb (fun t => let '(h, ds, g) := t in
    proportional (read g) f && plainly_zero (read h) &&
    forallb (fun d => plainly_nonzero (read d)) ds) hints.
Definition known_zero (f : polynomial) : bool :=
  zero_by_hint f || existsb (fun t => let '(h, ds, g) := t in
    proportional (read h) f && zero_by_hint (read g)) hints.
Definition nonzero_by_hint (f : polynomial) : bool :=
  plainly_nonzero f ||
  match f with Pc c => number_is_unit c | _ => false end ||
  existsb (fun t => let '(h, _, g) := t in
    proportional (read g) f && plainly_nonzero (read h)) hints.
Definition known_nonzero (f : polynomial) : bool :=
  nonzero_by_hint f || existsb (fun t => let '(h, ds, g) := t in
    proportional (read h) f && nonzero_by_hint (read g) &&
    forallb (fun d => plainly_nonzero (read d)) ds) hints.
Definition excludes (i : item) : bool :=
  match i with
  | Direct zeros f _ _ => forallb known_zero (List.map read zeros) && known_nonzero (read f)
  | Excluded zeros nonzeros _ =>
      forallb known_zero (List.map read zeros) && forallb known_nonzero (List.map read nonzeros)
  end.
Definition closed : bool :=
  existsb (fun z => match z with Pc c => number_is_unit c | _ => false end) zs ||
  existsb known_zero ns || existsb excludes (items shown).
End Place.

(* Whether assumptions, each of them a formula or its negation, cannot all hold over a field. *)
Variables (evaluate : list polynomial -> scalar -> fraction)
          (evaluate_quat : list polynomial -> quat -> quaternion fraction).
Definition difference ns x y : fraction := sub (Operations := fractions ns) (evaluate ns x) (evaluate ns y).
Definition differences ns p q : list fraction :=
  let d := qsub (operations := fractions ns) (evaluate_quat ns p) (evaluate_quat ns q) in
  List.cons (re d) (List.cons (im d) (List.cons (jm d) (List.cons (km d) List.nil))).
Definition tops (ds : list fraction) := List.map top (List.filter valid ds).
Fixpoint refuted (fuel : nat) (todo : list (bool * formula)) (zs ns : list polynomial) : bool :=
  match fuel, todo with
  | O, _ => false
  | _, List.nil => closed zs ns
  | S fuel, List.cons (sign, f) rest =>
      let go first := refuted fuel (first ++ rest) zs ns in
      let both g s h t := go (List.cons (s, g) (List.cons (t, h) List.nil)) in
      let only g s := go (List.cons (s, g) List.nil) in
      let apart d := if valid d then vanishes (top d) || refuted fuel rest zs (ns ++ List.cons (top d) List.nil)
                     else refuted fuel rest zs ns in
      match f, sign with
      | Equal x y, true => refuted fuel rest (tops (List.cons (difference ns x y) List.nil) ++ zs) ns
      | Equal x y, false => apart (difference ns x y)
      | Same p q, true => refuted fuel rest (tops (differences ns p q) ++ zs) ns
      | Same p q, false => forallb apart (differences ns p q)
      | Unit _, _ => refuted fuel rest zs ns
      | Not g, _ => only g (negb sign)
      | And g h, true => both g true h true
      | And g h, false => only g false && both g true h false
      | Or g h, true => only g true && both g false h true
      | Or g h, false => both g false h false
      | Imp g h, true => only g false && both g true h true
      | Imp g h, false => both g true h false
      | Iff g h, true => both g true h true && both g false h false
      | Iff g h, false => both g true h false && both g false h true
      end
  end.

(* The same over a commutative ring, where it need not be decided whether two elements are equal. *)
Fixpoint cases_of (f : formula) : option (list (list polynomial)) :=
  match f with
  | Equal x y => Some (List.cons (tops (List.cons (difference List.nil x y) List.nil)) List.nil)
  | Same p q => Some (List.cons (tops (differences List.nil p q)) List.nil)
  | And g h => match cases_of g, cases_of h with
      | Some gs, Some hs => Some (flat_map (fun u => List.map (fun v => u ++ v) hs) gs)
      | _, _ => None
      end
  | Or g h => match cases_of g, cases_of h with Some gs, Some hs => Some (gs ++ hs) | _, _ => None end
  | _ => None
  end.
Definition is_derived (zs : list polynomial) (d : fraction) : bool :=
  existsb (fun z => match z with Pc c => number_is_unit c | _ => false end) zs ||
  valid d && (vanishes (top d) || existsb (fun z => proportional z (top d)) zs ||
    existsb (fun i => match i with
      | Direct zeros f _ _ => forallb (plainly_zero zs) (List.map read zeros) &&
          (proportional (read f) (top d) || match read f with Pc c => number_is_unit c | _ => false end)
      | _ => false
      end) (items shown)).
Fixpoint derived (zs : list polynomial) (f : formula) : bool :=
  match f with
  | Equal x y => is_derived zs (difference List.nil x y)
  | Same p q => forallb (is_derived zs) (differences List.nil p q)
  | And g h => derived zs g && derived zs h
  | Or g h => derived zs g || derived zs h
  | Imp g h => match cases_of g with
      | Some gs => forallb (fun more => derived (more ++ zs) h) gs
      | None => false
      end
  | Iff g h => match cases_of g, cases_of h with
      | Some gs, Some hs => forallb (fun more => derived (more ++ zs) h) gs &&
          forallb (fun more => derived (more ++ zs) g) hs
      | _, _ => false
      end
  | _ => false
  end.
End Computed.
