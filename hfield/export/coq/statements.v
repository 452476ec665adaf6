
(* ---------------------------------------------------------------------------------------------- *)
(* Statements as data. [says] turns one into a proposition, which unfolds to what a reader would   *)
(* write down; the same terms are computed with in other rings, fractions of polynomials above all. *)
(* ---------------------------------------------------------------------------------------------- *)


Class Inverse (R : Type) := inv : R -> R.
Notation "x / y" := (mul x (inv y)) : scalar_scope.
Definition qinv {R} `{Operations R} `{Inverse R} (A : algebra R) q := qscale (inv (norm A q)) (conj A q).
Notation "q [/] s" := (qscale (inv s) q) (at level 40, left associativity).
Definition unit {R} `{Operations R} (x : R) := exists y, mul x y = one.

Inductive place := at_e | at_i | at_j | at_k.
Inductive scalar :=
  | SNum (n : Z) | SVar (n : nat) | SNeg (x : scalar) | SAdd (x y : scalar) | SSub (x y : scalar)
  | SMul (x y : scalar) | SDiv (x y : scalar) | SPow (x : scalar) (n : nat) | SInv (x : scalar)
  | SCoordinate (c : place) (q : quat) | SNorm (q : quat) | STrace (q : quat)
with quat :=
  | QVar (n : nat) | QBasis (c : place) | QEmbed (x : scalar) | QNeg (q : quat)
  | QAdd (p q : quat) | QSub (p q : quat) | QMul (p q : quat) | QScale (x : scalar) (q : quat)
  | QOver (q : quat) (x : scalar) | QPow (q : quat) (n : nat) | QConj (q : quat)
  | QVector (q : quat) | QComm (p q : quat) | QInv (q : quat).
Scheme scalar_terms := Induction for scalar Sort Prop with quat_terms := Induction for quat Sort Prop.
Combined Scheme terms_induction from scalar_terms, quat_terms.

Inductive formula :=
  | Equal (x y : scalar) | Same (p q : quat) | Unit (x : scalar) | Not (f : formula)
  | And (f g : formula) | Or (f g : formula) | Imp (f g : formula) | Iff (f g : formula).

(* For all quaternions and scalars, [given] implies that there are some with the conclusion. *)
Record statement := Statement {
  constant_a : scalar; constant_t : scalar; constant_b : scalar;
  quaternions : nat; scalars : nat; given : list formula;
  found_quaternions : nat; found_scalars : nat; conclusion : formula }.

Section Meaning.
Context {R : Type} {operations : Operations R} {inverse : Inverse R}.

Definition coordinate (c : place) : quaternion R -> R :=
  match c with at_e => re | at_i => im | at_j => jm | at_k => km end.
Definition basis (c : place) : quaternion R :=
  match c with at_e => e | at_i => i | at_j => j | at_k => k end.

Section Terms.
Variables (A : algebra R) (qs : list (quaternion R)) (ss : list R).
Fixpoint scalar_value (x : scalar) : R :=
  match x with
  | SNum n => num n
  | SVar n => nth n ss zero
  | SNeg x => opp (scalar_value x)
  | SAdd x y => add (scalar_value x) (scalar_value y)
  | SSub x y => sub (scalar_value x) (scalar_value y)
  | SMul x y => mul (scalar_value x) (scalar_value y)
  | SDiv x y => mul (scalar_value x) (inv (scalar_value y))
  | SPow x n => pow (scalar_value x) n
  | SInv x => inv (scalar_value x)
  | SCoordinate c q => coordinate c (quat_value q)
  | SNorm q => norm A (quat_value q)
  | STrace q => trace A (quat_value q)
  end
with quat_value (q : quat) : quaternion R :=
  match q with
  | QVar n => nth n qs (embed zero)
  | QBasis c => basis c
  | QEmbed x => embed (scalar_value x)
  | QNeg q => qopp (quat_value q)
  | QAdd p q => qadd (quat_value p) (quat_value q)
  | QSub p q => qsub (quat_value p) (quat_value q)
  | QMul p q => qmul A (quat_value p) (quat_value q)
  | QScale x q => qscale (scalar_value x) (quat_value q)
  | QOver q x => qscale (inv (scalar_value x)) (quat_value q)
  | QPow q n => qpow A (quat_value q) n
  | QConj q => conj A (quat_value q)
  | QVector q => vector (quat_value q)
  | QComm p q => comm A (quat_value p) (quat_value q)
  | QInv q => qinv A (quat_value q)
  end.
Fixpoint holds (f : formula) : Prop :=
  match f with
  | Equal x y => scalar_value x = scalar_value y
  | Same p q => quat_value p = quat_value q
  | Unit x => unit (scalar_value x)
  | Not f => ~ holds f
  | And f g => holds f /\ holds g
  | Or f g => holds f \/ holds g
  | Imp f g => holds f -> holds g
  | Iff f g => holds f <-> holds g
  end.
Fixpoint hold_imply (hypotheses : list formula) (P : Prop) : Prop :=
  match hypotheses with List.nil => P | List.cons h rest => holds h -> hold_imply rest P end.
End Terms.

Definition constants (st : statement) (ss : list R) : algebra R :=
  let none := Hamilton in
  Algebra (scalar_value none List.nil ss (constant_a st))
          (scalar_value none List.nil ss (constant_t st))
          (scalar_value none List.nil ss (constant_b st)).
Fixpoint for_all {T} (n : nat) (P : list T -> Prop) : Prop :=
  match n with O => P List.nil | S m => forall x, for_all m (fun l => P (List.cons x l)) end.
Fixpoint there_are {T} (n : nat) (P : list T -> Prop) : Prop :=
  match n with O => P List.nil | S m => exists x, there_are m (fun l => P (List.cons x l)) end.
Definition says (st : statement) : Prop :=
  for_all (quaternions st) (fun qs => for_all (scalars st) (fun ss =>
    hold_imply (constants st ss) qs ss (given st)
      (there_are (found_quaternions st) (fun more => there_are (found_scalars st) (fun others =>
        holds (constants st ss) (qs ++ more) (ss ++ others) (conclusion st)))))).
End Meaning.

(* Terms computed in two rings, related by a relation that the operations respect. *)
Section Related.
Context {R : Type} {operations : Operations R} {inverse : Inverse R}.
Context {R' : Type} {operations' : Operations R'} {inverse' : Inverse R'}.
Variable rel : R -> R' -> Prop.
Hypothesis rel_zero : rel zero zero.
Hypothesis rel_one : rel one one.
Hypothesis rel_add : forall x x' y y', rel x x' -> rel y y' -> rel (add x y) (add x' y').
Hypothesis rel_sub : forall x x' y y', rel x x' -> rel y y' -> rel (sub x y) (sub x' y').
Hypothesis rel_mul : forall x x' y y', rel x x' -> rel y y' -> rel (mul x y) (mul x' y').
Hypothesis rel_opp : forall x x', rel x x' -> rel (opp x) (opp x').
Hypothesis rel_inv : forall x x', rel x x' -> rel (inv x) (inv x').
Definition qrel (q : quaternion R) (q' : quaternion R') : Prop :=
  rel (re q) (re q') /\ rel (im q) (im q') /\ rel (jm q) (jm q') /\ rel (km q) (km q').
Definition arel (A : algebra R) (A' : algebra R') : Prop :=
  rel (const_a A) (const_a A') /\ rel (const_t A) (const_t A') /\ rel (const_b A) (const_b A').
Ltac related := repeat first [assumption | apply rel_add | apply rel_sub | apply rel_mul
  | apply rel_opp | apply rel_inv | apply rel_zero | apply rel_one].
Ltac parts := intros; repeat match goal with
  | H : qrel _ _ |- _ => destruct H as [? [? [? ?]]] end;
  repeat split; cbn [re im jm km qmul qsub qscale conj norm trace const_a const_t const_b]; related.
Lemma rel_pos : forall n, rel (gen_phiPOS one add mul n) (gen_phiPOS one add mul n).
Proof.
  induction n as [n IH | n IH |]; [| | apply rel_one];
    destruct n; cbn in *; repeat first [exact IH | apply rel_add | apply rel_mul | apply rel_one].
Qed.
Lemma rel_num : forall n, rel (num n) (num n).
Proof.
  intros [|n|n]; [exact rel_zero | apply rel_pos | apply rel_opp, rel_pos].
Qed.
Lemma rel_pow : forall n x x', rel x x' -> rel (pow x n) (pow x' n).
Proof.
  intros n x x' E; induction n as [| n IH]; [apply rel_one |].
  destruct n; [exact E | apply rel_mul; [exact E | exact IH]].
Qed.
Section Terms.
Variables (A : algebra R) (A' : algebra R').
Hypothesis same_algebra : arel A A'.
Let same_a := proj1 same_algebra.
Let same_t := proj1 (proj2 same_algebra).
Let same_b := proj2 (proj2 same_algebra).
Lemma rel_embed : forall x x', rel x x' -> qrel (embed x) (embed x').
Proof. intros; repeat split; related. Qed.
Lemma rel_qmul : forall p p' q q', qrel p p' -> qrel q q' -> qrel (qmul A p q) (qmul A' p' q').
Proof. parts. Qed.
Lemma rel_qsub : forall p p' q q', qrel p p' -> qrel q q' -> qrel (qsub p q) (qsub p' q').
Proof. parts. Qed.
Lemma rel_qscale : forall x x' q q', rel x x' -> qrel q q' -> qrel (qscale x q) (qscale x' q').
Proof. parts. Qed.
Lemma rel_conj : forall q q', qrel q q' -> qrel (conj A q) (conj A' q').
Proof. parts. Qed.
Lemma rel_norm : forall q q', qrel q q' -> rel (norm A q) (norm A' q').
Proof. parts. Qed.
Lemma rel_trace : forall q q', qrel q q' -> rel (trace A q) (trace A' q').
Proof. parts. Qed.
Lemma rel_basis : forall c, qrel (basis c) (basis c).
Proof. intros []; repeat split; related. Qed.
Lemma rel_qpow : forall n q q', qrel q q' -> qrel (qpow A q n) (qpow A' q' n).
Proof.
  intros n q q' E; induction n as [| n IH]; [repeat split; related |].
  destruct n; [exact E | apply rel_qmul; [exact E | exact IH]].
Qed.
Variables (qs : list (quaternion R)) (qs' : list (quaternion R')) (ss : list R) (ss' : list R').
Hypothesis same_quaternions : Forall2 qrel qs qs'.
Hypothesis same_scalars : Forall2 rel ss ss'.
Lemma rel_nth : forall T T' (r : T -> T' -> Prop) l l' x x', Forall2 r l l' -> r x x' ->
  forall n, r (nth n l x) (nth n l' x').
Proof. intros T T' r l l' x x' F E; induction F; intros []; cbn; auto. Qed.
Lemma rel_qadd : forall p p' q q', qrel p p' -> qrel q q' -> qrel (qadd p q) (qadd p' q').
Proof. parts. Qed.
Lemma rel_qopp : forall q q', qrel q q' -> qrel (qopp q) (qopp q').
Proof. parts. Qed.
Lemma rel_vector : forall q q', qrel q q' -> qrel (vector q) (vector q').
Proof. parts. Qed.
Lemma rel_coordinate : forall c q q', qrel q q' -> rel (coordinate c q) (coordinate c q').
Proof. intros [] q q' [? [? [? ?]]]; assumption. Qed.
Lemma rel_terms :
  (forall x, rel (scalar_value A qs ss x) (scalar_value A' qs' ss' x)) /\
  (forall q, qrel (quat_value A qs ss q) (quat_value A' qs' ss' q)).
Proof.
  apply terms_induction.
  - exact rel_num.
  - exact (rel_nth _ _ rel _ _ _ _ same_scalars rel_zero).
  - intros x E; exact (rel_opp _ _ E).
  - intros x E y F; exact (rel_add _ _ _ _ E F).
  - intros x E y F; exact (rel_sub _ _ _ _ E F).
  - intros x E y F; exact (rel_mul _ _ _ _ E F).
  - intros x E y F; exact (rel_mul _ _ _ _ E (rel_inv _ _ F)).
  - intros x E n; exact (rel_pow n _ _ E).
  - intros x E; exact (rel_inv _ _ E).
  - intros c q E; exact (rel_coordinate c _ _ E).
  - intros q E; exact (rel_norm _ _ E).
  - intros q E; exact (rel_trace _ _ E).
  - exact (rel_nth _ _ qrel _ _ _ _ same_quaternions (rel_embed _ _ rel_zero)).
  - exact rel_basis.
  - intros x E; exact (rel_embed _ _ E).
  - intros q E; exact (rel_qopp _ _ E).
  - intros p E q F; exact (rel_qadd _ _ _ _ E F).
  - intros p E q F; exact (rel_qsub _ _ _ _ E F).
  - intros p E q F; exact (rel_qmul _ _ _ _ E F).
  - intros x E q F; exact (rel_qscale _ _ _ _ E F).
  - intros q E x F; exact (rel_qscale _ _ _ _ (rel_inv _ _ F) E).
  - intros q E n; exact (rel_qpow n _ _ E).
  - intros q E; exact (rel_conj _ _ E).
  - intros q E; exact (rel_vector _ _ E).
  - intros p E q F; exact (rel_qsub _ _ _ _ (rel_qmul _ _ _ _ E F) (rel_qmul _ _ _ _ F E)).
  - intros q E; exact (rel_qscale _ _ _ _ (rel_inv _ _ (rel_norm _ _ E)) (rel_conj _ _ E)).
Qed.
End Terms.
End Related.
