
(* ---------------------------------------------------------------------------------------------- *)
(* Lemma 1: multilinear maps are equal when they are equal on all tuples of basis vectors, for any *)
(* number of arguments and any number of basis vectors.                                            *)
(* ---------------------------------------------------------------------------------------------- *)

Section Multilinear_maps.
(* Scalars, vectors and values with the operations that linear maps respect; no law is needed. *)
Context {R V W : Type}.
Variables (V0 : V) (Vadd : V -> V -> V) (Vscale : R -> V -> V).
Variables (W0 : W) (Wadd : W -> W -> W) (Wscale : R -> W -> W).
(* The vectors [basis 0], ..., [basis (n - 1)] span V. *)
Variables (n : nat) (basis : nat -> V).
Fixpoint sum (c : nat -> R) (m : nat) : V :=
  match m with O => V0 | S l => Vadd (Vscale (c l) (basis l)) (sum c l) end.
Hypothesis span : forall v, exists c, v = sum c n.

(* Maps of [d] arguments, one after the other; what is said of values is said of maps pointwise. *)
Fixpoint maps (d : nat) : Type := match d with O => W | S m => V -> maps m end.
Fixpoint same d : maps d -> maps d -> Prop :=
  match d with O => fun f g => f = g | S m => fun f g => forall v, same m (f v) (g v) end.
Fixpoint null d : maps d := match d with O => W0 | S m => fun _ => null m end.
Fixpoint line (s : R) d : maps d -> maps d -> maps d :=
  match d with
  | O => fun f g => Wadd (Wscale s f) g
  | S m => fun f g v => line s m (f v) (g v)
  end.
Fixpoint multilinear d : maps d -> Prop :=
  match d with
  | O => fun _ => True
  | S m => fun f =>
      (forall s a b, same m (f (Vadd (Vscale s a) b)) (line s m (f a) (f b))) /\
      same m (f V0) (null m) /\ forall v, multilinear m (f v)
  end.
Fixpoint same_on_basis d : maps d -> maps d -> Prop :=
  match d with
  | O => fun f g => f = g
  | S m => fun f g => forall l, (l < n)%nat -> same_on_basis m (f (basis l)) (g (basis l))
  end.

Lemma same_refl : forall d f, same d f f.
Proof. induction d as [| d IH]; intro f; [reflexivity | intro v; apply IH]. Qed.
Lemma same_sym : forall d f g, same d f g -> same d g f.
Proof.
  induction d as [| d IH]; intros f g E; [symmetry; exact E | intro v; apply IH, E].
Qed.
Lemma same_trans : forall d f g h, same d f g -> same d g h -> same d f h.
Proof.
  induction d as [| d IH]; intros f g h E F; [exact (eq_trans E F) | intro v].
  exact (IH _ _ _ (E v) (F v)).
Qed.
Lemma same_line : forall s d f f' g g',
  same d f f' -> same d g g' -> same d (line s d f g) (line s d f' g').
Proof.
  induction d as [| d IH]; intros f f' g g' E F; [cbn in *; congruence | intro v].
  exact (IH _ _ _ _ (E v) (F v)).
Qed.

Theorem multilinear_maps_agree : forall d f g, multilinear d f -> multilinear d g ->
  same_on_basis d f g <-> same d f g.
Proof.
  induction d as [| d agree]; cbn; [tauto |].
  intros f g [Lf [Zf Mf]] [Lg [Zg Mg]]; split.
  - intros B v. destruct (span v) as [c ->].
    assert (part : forall m, (m <= n)%nat -> same d (f (sum c m)) (g (sum c m))).
    { induction m as [| m step]; intro small; cbn.
      - apply (same_trans _ _ _ _ Zf), same_sym, Zg.
      - apply (same_trans _ _ _ _ (Lf _ _ _)). apply same_sym.
        apply (same_trans _ _ _ _ (Lg _ _ _)). apply same_sym, same_line.
        + apply agree; auto.
        + apply step. apply le_S_n, le_S, small. }
    apply part, le_n.
  - intros A l _. apply agree; auto.
Qed.

(* The last argument fixed. *)
Fixpoint fix_last d : maps (S d) -> V -> maps d :=
  match d with O => fun f x => f x | S m => fun f x v => fix_last m (f v) x end.
Lemma fix_last_same : forall d f g x,
  same (S d) f g -> same d (fix_last d f x) (fix_last d g x).
Proof.
  induction d as [| d IH]; intros f g x E; [apply E |]. intro v. apply IH. exact (E v).
Qed.
Lemma fix_last_line : forall d s f g x,
  same d (fix_last d (line s (S d) f g) x) (line s d (fix_last d f x) (fix_last d g x)).
Proof.
  induction d as [| d IH]; intros s f g x; [reflexivity |]. intro v. apply (IH s (f v) (g v)).
Qed.
Lemma fix_last_null : forall d x, same d (fix_last d (null (S d)) x) (null d).
Proof. induction d as [| d IH]; intro x; [reflexivity |]. intro v. apply (IH x). Qed.
Theorem curried_is_multilinear : forall d f x,
  multilinear (S d) f -> multilinear d (fix_last d f x).
Proof.
  induction d as [| d IH]; intros f x [L [Z M]]; [exact I |]. split; [| split].
  - intros s a b. apply (same_trans _ _ _ _ (fix_last_same _ _ _ x (L s a b))).
    apply fix_last_line.
  - apply (same_trans _ _ _ _ (fix_last_same _ _ _ x Z)). apply fix_last_null.
  - intro v. apply IH, M.
Qed.

(* Linearity in the last argument, and the sum over a basis in it. *)
Lemma last_is_linear : forall d f s a b, multilinear (S d) f ->
  same d (fix_last d f (Vadd (Vscale s a) b)) (line s d (fix_last d f a) (fix_last d f b)).
Proof.
  induction d as [| d IH]; intros f s a b [L [Z M]]; [apply L |]. intro v. apply IH, M.
Qed.
Lemma last_of_zero : forall d f, multilinear (S d) f -> same d (fix_last d f V0) (null d).
Proof.
  induction d as [| d IH]; intros f [L [Z M]]; [exact Z |]. intro v. apply IH, M.
Qed.
Fixpoint sum_of_maps d (c : nat -> R) (f : nat -> maps d) (m : nat) : maps d :=
  match m with O => null d | S l => line (c l) d (f l) (sum_of_maps d c f l) end.
Theorem sum_in_the_last_argument : forall d f c m, multilinear (S d) f ->
  same d (fix_last d f (sum c m)) (sum_of_maps d c (fun l => fix_last d f (basis l)) m).
Proof.
  intros d f c m M; induction m as [| m step]; [apply last_of_zero, M |].
  apply (same_trans _ _ _ _ (last_is_linear _ _ _ _ _ M)).
  apply same_line; [apply same_refl | exact step].
Qed.
