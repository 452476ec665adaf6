
(* ---------------------------------------------------------------------------------------------- *)
(* Every field (in which it can be told whether two elements are equal).                          *)
(* ---------------------------------------------------------------------------------------------- *)

Section Fields.
Context {R : Type} {operations : Operations R}.
Variable inv : R -> R.
Local Open Scope scalar_scope.
Local Notation "x / y" := (mul x (inv y)) : scalar_scope.
Hypothesis field_laws : field_theory zero one add mul sub opp (fun x y => x / y) inv (@eq R).
Hypothesis equal_or_not : forall x y : R, {x = y} + {x <> y}.
Add Field field : field_laws.
Let laws := F_R field_laws.
Local Notation nil := (combination_nil).
Local Notation cons c equation rest := (combination_cons laws c _ _ _ equation rest).
Local Notation qinv A q := (qscale (inv (norm A q)) (conj A q)).
Local Notation "q [/] s" := (qscale (inv s) q) (at level 40, left associativity).
Ltac inverses := repeat match goal with |- context [inv ?x] => generalize (inv x); intro end.
Ltac calculate := first [inverses; polynomials laws | unfolded; ring].
Ltac equations :=
  intros; repeat match goal with |- _ /\ _ => split end; try apply coordinates; calculate.
Ltac combine proof := refine (by_combination laws _ _ _ proof _); calculate.
Implicit Types (p q r : quaternion R) (A : algebra R) (s x y : R).

Lemma one_is_not_zero : (1 : R) <> 0.
Proof. exact (F_1_neq_0 field_laws). Qed.
Lemma inverse : forall x, x <> 0 -> x * inv x = 1.
Proof. intros x N. field. exact N. Qed.
Lemma cancel : forall d x y, d <> 0 -> d * x = d * y -> x = y.
Proof.
  intros d x y N E. transitivity (inv d * (d * x)); [field; exact N |].
  rewrite E. field. exact N.
Qed.
Lemma decidable_scalars : forall x y, decidable (x = y).
Proof. intros x y; destruct (equal_or_not x y); [left | right]; assumption. Qed.
Lemma differ_somewhere : forall p q, p <> q ->
  re p <> re q \/ im p <> im q \/ jm p <> jm q \/ km p <> km q.
Proof.
  intros p q N.
  destruct (equal_or_not (re p) (re q)); [| left; assumption].
  destruct (equal_or_not (im p) (im q)); [| right; left; assumption].
  destruct (equal_or_not (jm p) (jm q)); [| right; right; left; assumption].
  destruct (equal_or_not (km p) (km q)); [| right; right; right; assumption].
  exfalso; apply N, coordinates; assumption.
Qed.
Lemma decidable_quaternions : forall p q, decidable (p = q).
Proof.
  intros p q.
  destruct (equal_or_not (re p) (re q)) as [|N]; [| right; intros ->; apply N; reflexivity].
  destruct (equal_or_not (im p) (im q)) as [|N]; [| right; intros ->; apply N; reflexivity].
  destruct (equal_or_not (jm p) (jm q)) as [|N]; [| right; intros ->; apply N; reflexivity].
  destruct (equal_or_not (km p) (km q)) as [|N]; [| right; intros ->; apply N; reflexivity].
  left; apply coordinates; assumption.
Qed.
Ltac decided := repeat first
  [ apply decidable_scalars | apply decidable_quaternions
  | apply dec_and | apply dec_or | apply dec_iff | apply dec_not | apply dec_imp ].
(* The laws of logic that need a decision, which [decided] finds once the formula is known. *)
Lemma not_both : forall P Q : Prop, ~ (P /\ Q) -> decidable P -> ~ P \/ ~ Q.
Proof. intros P Q N D. exact (not_and P Q D N). Qed.
Lemma twice_not : forall P : Prop, ~ ~ P -> decidable P -> P.
Proof. intros P N D. exact (not_not P D N). Qed.
Lemma either : forall P Q : Prop, (P -> Q) -> decidable P -> ~ P \/ Q.
Proof. intros P Q N D. exact (imp_simp P Q D N). Qed.
Lemma not_implied : forall P Q : Prop, ~ (P -> Q) -> decidable P -> P /\ ~ Q.
Proof. intros P Q N D. exact (Decidable.not_imp P Q D N). Qed.
Lemma not_equivalent : forall P Q : Prop, ~ (P <-> Q) -> decidable P -> decidable Q ->
  (P /\ ~ Q) \/ (~ P /\ Q).
Proof. intros P Q N D E. exact (Decidable.not_iff P Q D E N). Qed.

Theorem inverse_of_quaternion : forall A q, norm A q <> 0 ->
  q [*A] qinv A q = e /\ qinv A q [*A] q = e.
Proof.
  intros A q N; split; apply coordinates;
    first [calculate | combine (cons 1 (inverse _ N) nil)].
Qed.
Theorem invertible_iff : forall A q,
  (exists p, q [*A] p = e /\ p [*A] q = e) <-> norm A q <> 0.
Proof.
  intros A q; split.
  - intros [p [E _]] Z. apply one_is_not_zero.
    rewrite <- (norm_of_invertible laws A q p E), Z. ring.
  - intro N; exists (qinv A q). apply inverse_of_quaternion, N.
Qed.

(* When H is a division algebra: exactly when -1 is no sum of two squares. *)
Definition division := forall q, q <> embed 0 -> exists p, q [*H] p = e /\ p [*H] q = e.
Definition anisotropic := forall q, norm H q = 0 -> q = embed 0.
Definition minus_one_is_sum_of_two_squares := exists x y, x * x + y * y = - (1).
Theorem division_iff_anisotropic : division <-> anisotropic.
Proof.
  split.
  - intros D q Z. destruct (decidable_quaternions q (embed 0)) as [E | N]; [exact E |].
    exfalso. apply (proj1 (invertible_iff H q) (D q N)), Z.
  - intros A q N. apply invertible_iff. intro Z. exact (N (A q Z)).
Qed.
Lemma ratio : forall x y, x * x + y * y = 0 -> y <> 0 -> minus_one_is_sum_of_two_squares.
Proof.
  intros x y E N; exists (x / y), 0.
  transitivity ((x * x + y * y) / (y * y) - 1); [field; exact N |]. rewrite E. field. exact N.
Qed.
Theorem anisotropic_iff_level_above_2 : anisotropic <-> ~ minus_one_is_sum_of_two_squares.
Proof.
  split.
  - intros A [x [y E]]. apply one_is_not_zero.
    refine (f_equal jm (A (Quaternion x y 1 0) _)).
    combine (cons 1 E nil).
  - intros L [a b c d] Z. rewrite (norm_of_coordinates laws) in Z. cbn in Z.
    destruct (equal_or_not (a * a + b * b) 0) as [E | N].
    + assert (F : c * c + d * d = 0).
      { combine (cons 1 Z (cons (- (1)) E nil)). }
      destruct (equal_or_not b 0) as [-> | N]; [| elim (L (ratio a b E N))].
      destruct (equal_or_not a 0) as [-> | N].
      2: { elim L. apply (ratio 0 a); [combine (cons 1 E nil) | exact N]. }
      destruct (equal_or_not d 0) as [-> | N]; [| elim (L (ratio c d F N))].
      destruct (equal_or_not c 0) as [-> | N]; [reflexivity |].
      elim L. apply (ratio 0 c); [combine (cons 1 F nil) | exact N].
    + elim L. exists ((a * c + b * d) / (a * a + b * b)), ((a * d - b * c) / (a * a + b * b)).
      transitivity ((a * a + b * b + c * c + d * d) / (a * a + b * b) - 1); [field; exact N |].
      rewrite Z. field. exact N.
Qed.
