From Coq Require Import QArith Qround Qcanon ZArith Znumtheory List Bool Lia Ring Ring_theory Ring_polynom InitialRing Field Decidable.

(* ---------------------------------------------------------------------------------------------- *)
(* Definitions. The operations of a ring stand together in one record; that they are those of a    *)
(* commutative ring, or of a field, is a hypothesis of the sections below and never an axiom.      *)
(* ---------------------------------------------------------------------------------------------- *)

Class Operations (R : Type) := {
  zero : R; one : R; add : R -> R -> R; mul : R -> R -> R; sub : R -> R -> R; opp : R -> R }.

Declare Scope scalar_scope.
Notation "0" := zero : scalar_scope.
Notation "1" := one : scalar_scope.
Notation "x + y" := (add x y) : scalar_scope.
Notation "x * y" := (mul x y) : scalar_scope.
Notation "x - y" := (sub x y) : scalar_scope.
Notation "- x" := (opp x) : scalar_scope.
Local Open Scope scalar_scope.

Record quaternion (R : Type) := Quaternion { re : R; im : R; jm : R; km : R }.
Arguments Quaternion {R}.
Arguments re {R}.
Arguments im {R}.
Arguments jm {R}.
Arguments km {R}.

(* The algebra with i*i = a + t*i, j*j = b, i*j = k, j*i = t*j - k. *)
Record algebra (R : Type) := Algebra { const_a : R; const_t : R; const_b : R }.
Arguments Algebra {R}.
Arguments const_a {R}.
Arguments const_t {R}.
Arguments const_b {R}.

Section Definitions.
Context {R : Type} {operations : Operations R}.
Implicit Types (p q : quaternion R) (A : algebra R).

(* The image of an integer, and powers of scalars. *)
Definition num (n : Z) : R := gen_phiZ zero one add mul opp n.
Fixpoint pow (x : R) (n : nat) : R :=
  match n with O => 1 | S O => x | S m => x * pow x m end.

Definition embed (s : R) := Quaternion s 0 0 0.
Definition e := Quaternion 1 0 0 0.
Definition i := Quaternion 0 1 0 0.
Definition j := Quaternion 0 0 1 0.
Definition k := Quaternion 0 0 0 1.
Definition Hamilton := Algebra (- (1)) 0 (- (1)).

Definition qadd p q := Quaternion (re p + re q) (im p + im q) (jm p + jm q) (km p + km q).
Definition qsub p q := Quaternion (re p - re q) (im p - im q) (jm p - jm q) (km p - km q).
Definition qopp q := Quaternion (- re q) (- im q) (- jm q) (- km q).
Definition qscale s q := Quaternion (s * re q) (s * im q) (s * jm q) (s * km q).
Definition qmul A p q :=
  let a := const_a A in let t := const_t A in let b := const_b A in
  Quaternion
    (re p * re q + a * (im p * im q) + b * (jm p * jm q + t * (jm p * km q) - a * (km p * km q)))
    (re p * im q + im p * re q + t * (im p * im q) + b * (km p * jm q - jm p * km q))
    (re p * jm q + jm p * re q + t * (jm p * im q) + a * (im p * km q - km p * im q))
    (re p * km q + km p * re q + im p * jm q - jm p * im q + t * (im p * km q)).
Fixpoint qpow A q (n : nat) : quaternion R :=
  match n with O => e | S O => q | S m => qmul A q (qpow A q m) end.
Definition conj A q := Quaternion (re q + const_t A * im q) (- im q) (- jm q) (- km q).
Definition norm A q :=
  let a := const_a A in let t := const_t A in let b := const_b A in
  re q * re q + t * (re q * im q) - a * (im q * im q)
  - b * (jm q * jm q + t * (jm q * km q) - a * (km q * km q)).
Definition trace A q := re q + re q + const_t A * im q.
Definition vector q := Quaternion 0 (im q) (jm q) (km q).
Definition comm A p q := qsub (qmul A p q) (qmul A q p).
End Definitions.
Arguments num {R operations} n%Z_scope.
Arguments pow {R operations} x%scalar_scope n%nat_scope.
Arguments qpow {R operations} A q n%nat_scope.

Notation H := Hamilton.
Notation "p [+] q" := (qadd p q) (at level 50, left associativity).
Notation "p [-] q" := (qsub p q) (at level 50, left associativity).
Notation "[-] q" := (qopp q) (at level 35, right associativity).
Notation "s [.] q" := (qscale s q) (at level 40, left associativity).
Notation "p [* A ] q" := (qmul A p q)
  (at level 40, A at level 99, left associativity, format "p  [* A ]  q").

(* Identities between polynomials, quickly: the same definitions are read over Coq's own polynomial
   expressions, whose normal forms [vm_compute] compares; [ring_correct] carries that over to R. *)
Definition expression := PExpr Z.
Global Instance expressions : Operations expression :=
  { zero := PEO; one := PEI; add := @PEadd Z; mul := @PEmul Z; sub := @PEsub Z; opp := @PEopp Z }.
Definition value {R} {operations : Operations R} : list R -> expression -> R :=
  PEeval 0 1 add mul sub opp (gen_phiZ zero one add mul opp) id_phi_N (pow_N 1 mul).
Definition normal : expression -> Pol Z :=
  norm_subst 0%Z 1%Z Z.add Z.mul Z.sub Z.opp Zeq_bool Z.quotrem 0 List.nil.
Lemma by_normal_form : forall {R} {operations : Operations R},
  ring_theory zero one add mul sub opp (@eq R) -> forall l x y,
  Peq Zeq_bool (normal x) (normal y) = true -> value l x = value l y.
Proof.
  intros R operations laws l x y E.
  exact (ring_correct (Eqsth R) (Eq_ext _ _ _) (Rth_ARth (Eqsth R) (Eq_ext _ _ _) laws)
    (gen_phiZ_morph (Eqsth R) (Eq_ext _ _ _) laws) (pow_N_th _ _ (Eqsth R))
    (Ztriv_div_th (Eqsth R) _) 0 l List.nil x y I E).
Qed.
(* The coordinates, structure constants and scalars around, as a list. *)
Ltac atoms R found :=
  match goal with
  | q : quaternion R |- _ =>
      lazymatch found with
      | context [re q] => fail
      | _ => atoms R constr:(cons (re q) (cons (im q) (cons (jm q) (cons (km q) found))))
      end
  | A : algebra R |- _ =>
      lazymatch found with
      | context [const_a A] => fail
      | _ => atoms R constr:(cons (const_a A) (cons (const_t A) (cons (const_b A) found)))
      end
  | s : R |- _ =>
      lazymatch found with
      | context [cons s _] => fail
      | _ => atoms R constr:(cons s found)
      end
  | _ => found
  end.
(* A term over R as an expression, variable number n standing for the first of the atoms. *)
Ltac reading R operations term list n :=
  lazymatch list with
  | cons (re ?q) (cons (im ?q) (cons (jm ?q) (cons (km ?q) ?rest))) =>
      lazymatch (eval pattern q in term) with
      | ?f _ =>
          let g := reading R operations f rest (n + 4)%positive in
          constr:(g (Quaternion (PEX Z n) (PEX Z (n + 1)) (PEX Z (n + 2)) (PEX Z (n + 3))))
      end
  | cons (const_a ?A) (cons (const_t ?A) (cons (const_b ?A) ?rest)) =>
      lazymatch (eval pattern A in term) with
      | ?f _ =>
          let g := reading R operations f rest (n + 3)%positive in
          constr:(g (Algebra (PEX Z n) (PEX Z (n + 1)) (PEX Z (n + 2))))
      end
  | cons ?s ?rest =>
      lazymatch (eval pattern s in term) with
      | ?f _ => let g := reading R operations f rest (n + 1)%positive in constr:(g (PEX Z n))
      end
  | _ => lazymatch (eval pattern R, operations in term) with
         | ?f _ _ => constr:(f expression expressions)
         end
  end.
Ltac polynomials laws :=
  lazymatch type of laws with
  | @ring_theory ?R _ _ _ _ _ _ _ =>
      lazymatch goal with
      | operations : Operations R |- ?x = ?y =>
          let list := atoms R (@List.nil R) in
          let left := reading R operations x list 1%positive in
          let right := reading R operations y list 1%positive in
          let equal := constr:(@eq_refl bool true
            <: Peq Zeq_bool (normal left) (normal right) = true) in
          vm_cast_no_check (by_normal_form laws list left right equal)
      end
  end.

(* Equations between polynomials in the coordinates are unfolded, then decided by [ring]. *)
Ltac unfolded :=
  cbv [num gen_phiZ gen_phiPOS pow embed e i j k Hamilton qadd qsub qopp qscale qmul qpow conj norm
       trace vector comm re im jm km const_a const_t const_b].

Section Tools.
Context {R : Type} {operations : Operations R}.

Lemma coordinates : forall p q : quaternion R,
  re p = re q -> im p = im q -> jm p = jm q -> km p = km q -> p = q.
Proof. intros [] []; cbn; intros; subst; reflexivity. Qed.

Hypothesis laws : ring_theory zero one add mul sub opp (@eq R).
Add Ring tools_ring : laws.

(* A linear combination of hypotheses: c1*(l1 - r1) + c2*(l2 - r2) + ... + 0 = 0. *)
Lemma combination_nil : 0 = 0.
Proof. reflexivity. Qed.
Lemma combination_cons : forall c l r rest, l = r -> rest = 0 -> c * (l - r) + rest = 0.
Proof. intros c l r rest -> ->; ring. Qed.
Lemma by_combination : forall x y z, z = 0 -> x - y = z -> x = y.
Proof. intros x y z -> E. transitivity (x - y + y); [ring | rewrite E; ring]. Qed.
Lemma difference_apart : forall x y, x <> y -> x - y <> 0.
Proof. intros x y N E; apply N. transitivity (x - y + y); [ring | rewrite E; ring]. Qed.
End Tools.
