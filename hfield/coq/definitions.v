From Coq Require Import ZArith Ring Field InitialRing Decidable.

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

(* Equations between polynomials in the coordinates: unfold, then Coq's decision procedure. *)
Ltac calculate :=
  cbv [num gen_phiZ gen_phiPOS pow embed e i j k Hamilton qadd qsub qopp qscale qmul qpow conj norm
       trace vector comm re im jm km const_a const_t const_b];
  ring.

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

Ltac equations :=
  intros; repeat match goal with |- _ /\ _ => split end; try apply coordinates; calculate.
