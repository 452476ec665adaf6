
(* ---------------------------------------------------------------------------------------------- *)
(* Statements about all associative rings, with an identity or without: words in letters, multiplied *)
(* out, and sums of word * relation * word.                                                        *)
(* ---------------------------------------------------------------------------------------------- *)

Definition associative_ring (R : Type) {operations : Operations R} : Prop :=
  (forall x y : R, x + y = y + x) /\ (forall x y z : R, x + (y + z) = (x + y) + z) /\
  (forall x : R, 0 + x = x) /\ (forall x : R, x + - x = 0) /\ (forall x y : R, x - y = x + - y) /\
  (forall x y z : R, x * (y * z) = (x * y) * z) /\
  (forall x y z : R, (x + y) * z = x * z + y * z) /\ (forall x y z : R, z * (x + y) = z * x + z * y).
Definition has_identity (R : Type) {operations : Operations R} : Prop :=
  forall x : R, 1 * x = x /\ x * 1 = x.
Notation "'every' 'associative' 'ring' R , P" :=
  (forall (R : Type) (operations : Operations R), associative_ring R -> P) (at level 200, R name).
Notation "'every' 'associative' 'ring' R 'with' 'identity' , P" :=
  (forall (R : Type) (operations : Operations R), associative_ring R -> has_identity R -> P)
  (at level 200, R name).
(* n times x. *)
Definition multiple {R : Type} {operations : Operations R} (n : Z) (x : R) : R :=
  match n with
  | Z0 => 0
  | Zpos p => Pos.iter (add x) 0 p
  | Zneg p => opp (Pos.iter (add x) 0 p)
  end.
Arguments multiple {R operations} n%Z_scope x%scalar_scope.

Inductive expression_of_letters :=
  | Letter (n : nat) | Nothing | Minus (t : expression_of_letters)
  | Plus (t u : expression_of_letters) | Less (t u : expression_of_letters)
  | Times (t u : expression_of_letters) | Multiple (c : Z) (t : expression_of_letters).
Notation words := (list (Z * list nat)).
Section Meaning_of_words.
Context {R : Type} {operations : Operations R}.
Variable letters : list R.
Fixpoint letters_value (t : expression_of_letters) : R :=
  match t with
  | Letter n => nth n letters 0
  | Nothing => 0
  | Minus t => - letters_value t
  | Plus t u => letters_value t + letters_value u
  | Less t u => letters_value t - letters_value u
  | Times t u => letters_value t * letters_value u
  | Multiple c t => multiple c (letters_value t)
  end.
Definition equations_hold (l : list (expression_of_letters * expression_of_letters)) : Prop :=
  Forall (fun e => letters_value (fst e) = letters_value (snd e)) l.
End Meaning_of_words.

Section Computed_words.
Variables (with_identity : bool) (modulus : Z).
Definition by_number (c : Z) (f : words) : words := List.map (fun t => ((c * fst t)%Z, snd t)) f.
Definition between (left : list nat) (f : words) (right : list nat) : words :=
  List.map (fun t => (fst t, left ++ snd t ++ right)) f.
Fixpoint words_of (t : expression_of_letters) : words :=
  match t with
  | Letter n => if with_identity && Nat.eqb n 0 then [(1%Z, [])] else [(1%Z, [n])]
  | Nothing => []
  | Minus t => by_number (-1) (words_of t)
  | Plus t u => words_of t ++ words_of u
  | Less t u => words_of t ++ by_number (-1) (words_of u)
  | Times t u => flat_map (fun v => by_number (fst v) (between (snd v) (words_of u) [])) (words_of t)
  | Multiple c t => by_number c (words_of t)
  end.
Fixpoint same_word (v w : list nat) : bool :=
  match v, w with
  | [], [] => true
  | m :: v, n :: w => Nat.eqb m n && same_word v w
  | _, _ => false
  end.
Definition coefficient (w : list nat) (f : words) : Z :=
  fold_right (fun t c => if same_word w (snd t) then (fst t + c)%Z else c) 0%Z f.
Definition divides_by_modulus (c : Z) : bool :=
  if Z.eqb modulus 0 then Z.eqb c 0 else Z.eqb (c mod modulus) 0.
Definition words_vanish (f : words) : bool :=
  forallb (fun t => divides_by_modulus (coefficient (snd t) f)) f.
Definition not_empty (f : words) : bool :=
  with_identity || forallb (fun t => match snd t with [] => false | _ => true end) f.
(* The parts of a proof: a number, a word, which relation, a word. *)
Definition part := (Z * list nat * nat * list nat)%type.
Definition sum_of_parts (relations : list words) (parts : list part) : words :=
  flat_map (fun p => let '(c, v, n, w) := p in by_number c (between v (nth n relations []) w)) parts.
Definition follows (relations : list (expression_of_letters * expression_of_letters))
  (goal : expression_of_letters * expression_of_letters) (parts : list part) : bool :=
  let rs := List.map (fun e => words_of (Less (fst e) (snd e))) relations in
  words_vanish (words_of (Less (fst goal) (snd goal)) ++ by_number (-1) (sum_of_parts rs parts)).
Fixpoint all_follow relations goals proofs : bool :=
  match goals, proofs with
  | [], [] => true
  | g :: gs, p :: ps => follows relations g p && all_follow relations gs ps
  | _, _ => false
  end.
End Computed_words.

Section Not_empty.
Variable with_identity : bool.
Lemma not_empty_nil : not_empty with_identity [] = true.
Proof. unfold not_empty. destruct with_identity; reflexivity. Qed.
Lemma not_empty_cons : forall c v f, not_empty with_identity ((c, v) :: f) = true ->
  (v <> [] \/ with_identity = true) /\ not_empty with_identity f = true.
Proof.
  unfold not_empty. intros c v f E. destruct with_identity; [split; [right |]; reflexivity |]. cbn in E.
  apply andb_true_iff in E. split; [left; intros ->; destruct E; discriminate | exact (proj2 E)].
Qed.
Lemma not_empty_app : forall f g, not_empty with_identity f = true -> not_empty with_identity g = true ->
  not_empty with_identity (f ++ g) = true.
Proof.
  unfold not_empty. intros f g E F. destruct with_identity; [reflexivity |]. cbn in *.
  rewrite forallb_app, E, F. reflexivity.
Qed.
Lemma not_empty_by : forall c f, not_empty with_identity f = true -> not_empty with_identity (by_number c f) = true.
Proof.
  unfold not_empty. intros c f E. destruct with_identity; [reflexivity |]. cbn in *.
  rewrite forallb_forall in *. intros t I. apply in_map_iff in I; destruct I as [u [<- I]]. exact (E u I).
Qed.
Lemma words_not_empty : forall t, not_empty with_identity (words_of with_identity t) = true.
Proof.
  induction t; cbn [words_of]; try (apply not_empty_by; assumption); try (apply not_empty_app; assumption).
  - unfold not_empty. destruct with_identity; reflexivity.
  - unfold not_empty. destruct with_identity; reflexivity.
  - apply not_empty_app; [assumption | apply not_empty_by; assumption].
  - revert IHt1. induction (words_of with_identity t1) as [| [c v] f IH]; intro E.
    + unfold not_empty. destruct with_identity; reflexivity.
    + cbn [flat_map]. apply not_empty_app.
      * apply not_empty_by. clear - IHt2. unfold not_empty in *. destruct with_identity; [reflexivity |].
        cbn in *. rewrite forallb_forall in *. intros t I. apply in_map_iff in I; destruct I as [u [<- I]].
        specialize (IHt2 u I). cbn. destruct (snd u), v; try discriminate; reflexivity.
      * apply IH. unfold not_empty in *. destruct with_identity; [reflexivity |]. cbn in *.
        apply andb_true_iff in E. exact (proj2 E).
Qed.
End Not_empty.

Section Words_are_right.
Context {R : Type} {operations : Operations R}.
Hypothesis laws : associative_ring R.
Let a_comm := proj1 laws.
Let a_assoc := proj1 (proj2 laws).
Let a_zero := proj1 (proj2 (proj2 laws)).
Let a_opp := proj1 (proj2 (proj2 (proj2 laws))).
Let a_sub := proj1 (proj2 (proj2 (proj2 (proj2 laws)))).
Let m_assoc := proj1 (proj2 (proj2 (proj2 (proj2 (proj2 laws))))).
Let m_left := proj1 (proj2 (proj2 (proj2 (proj2 (proj2 (proj2 laws)))))).
Let m_right := proj2 (proj2 (proj2 (proj2 (proj2 (proj2 (proj2 laws)))))).
Lemma add_cancel : forall x y z : R, x + y = x + z -> y = z.
Proof.
  intros x y z E. rewrite <- (a_zero y), <- (a_zero z), <- (a_opp x), (a_comm x (- x)).
  rewrite <- 2!a_assoc, E. reflexivity.
Qed.
Lemma opp_zero : - 0 = (0 : R).
Proof. rewrite <- (a_zero (- 0)). apply a_opp. Qed.
Lemma opp_unique : forall x y : R, x + y = 0 -> y = - x.
Proof. intros x y E. apply (add_cancel x). rewrite E, a_opp. reflexivity. Qed.
Lemma opp_add : forall x y : R, - (x + y) = - x + - y.
Proof.
  intros x y. symmetry. apply opp_unique.
  rewrite <- a_assoc, (a_comm y), <- a_assoc, (a_comm (- y)), a_opp, (a_comm (- x) 0), a_zero. apply a_opp.
Qed.
Lemma opp_opp : forall x : R, - - x = x.
Proof. intro x. symmetry. apply opp_unique. rewrite a_comm. apply a_opp. Qed.
Lemma mul_zero_left : forall x : R, 0 * x = 0.
Proof. intro x. apply (add_cancel (0 * x)). rewrite <- m_left, a_zero, a_comm, a_zero. reflexivity. Qed.
Lemma mul_zero_right : forall x : R, x * 0 = 0.
Proof. intro x. apply (add_cancel (x * 0)). rewrite <- m_right, a_zero, a_comm, a_zero. reflexivity. Qed.
Lemma mul_opp_left : forall x y : R, - x * y = - (x * y).
Proof. intros x y. apply opp_unique. rewrite <- m_left, a_opp. apply mul_zero_left. Qed.
Lemma mul_opp_right : forall x y : R, x * - y = - (x * y).
Proof. intros x y. apply opp_unique. rewrite <- m_right, a_opp. apply mul_zero_right. Qed.
Lemma multiple_one : forall x : R, multiple 1 x = x.
Proof. intro x. cbn. rewrite a_comm. apply a_zero. Qed.
Lemma multiple_succ : forall n (x : R), multiple (Z.succ n) x = x + multiple n x.
Proof.
  intros [| p | p] x.
  - reflexivity.
  - rewrite <- Pos2Z.inj_succ. cbn [multiple]. apply Pos.iter_succ.
  - induction p using Pos.peano_ind.
    + cbn. rewrite opp_add, opp_zero, a_assoc, a_opp. symmetry; apply a_zero.
    + replace (Z.succ (Z.neg (Pos.succ p))) with (Z.neg p) by lia.
      cbn [multiple]. rewrite Pos.iter_succ, opp_add, a_assoc, a_opp, a_zero. reflexivity.
Qed.
Lemma multiple_pred : forall n (x : R), multiple (Z.pred n) x = - x + multiple n x.
Proof.
  intros n x. apply (add_cancel x). rewrite <- multiple_succ, Z.succ_pred, a_assoc, a_opp, a_zero. reflexivity.
Qed.
Lemma multiple_sum : forall m n (x : R), multiple (m + n) x = multiple m x + multiple n x.
Proof.
  intros m n x. induction m using Z.peano_ind.
  - cbn. symmetry; apply a_zero.
  - rewrite Z.add_succ_l, 2!multiple_succ, IHm. apply a_assoc.
  - rewrite Z.add_pred_l, 2!multiple_pred, IHm. apply a_assoc.
Qed.
Lemma multiple_of_sum : forall n (x y : R), multiple n (x + y) = multiple n x + multiple n y.
Proof.
  intros n x y. induction n using Z.peano_ind.
  - cbn. symmetry; apply a_zero.
  - rewrite 3!multiple_succ, IHn, <- 2!a_assoc. f_equal. rewrite 2!a_assoc. f_equal. apply a_comm.
  - rewrite 3!multiple_pred, IHn, opp_add, <- 2!a_assoc. f_equal. rewrite 2!a_assoc. f_equal. apply a_comm.
Qed.
Lemma multiple_zero_of : forall n, multiple n (0 : R) = 0.
Proof.
  intro n. induction n using Z.peano_ind; [reflexivity | |].
  - rewrite multiple_succ, IHn. apply a_zero.
  - rewrite multiple_pred, IHn, opp_zero. apply a_zero.
Qed.
Lemma multiple_multiple : forall m n (x : R), multiple (m * n) x = multiple m (multiple n x).
Proof.
  intros m n x. induction m using Z.peano_ind; [reflexivity | |].
  - rewrite Z.mul_succ_l, Z.add_comm, multiple_sum, IHm, multiple_succ. reflexivity.
  - assert (E : (Z.pred m * n = - n + m * n)%Z) by lia. rewrite E, multiple_sum, IHm, multiple_pred. f_equal.
    apply opp_unique. rewrite <- multiple_sum, Z.add_opp_diag_r. reflexivity.
Qed.
Lemma multiple_minus : forall x : R, multiple (-1) x = - x.
Proof. intro x. cbn. f_equal. rewrite a_comm. apply a_zero. Qed.
Lemma multiple_left : forall n (x y : R), multiple n x * y = multiple n (x * y).
Proof.
  intros n x y. induction n using Z.peano_ind; [apply mul_zero_left | |].
  - rewrite 2!multiple_succ, m_left, IHn. reflexivity.
  - rewrite 2!multiple_pred, m_left, IHn, mul_opp_left. reflexivity.
Qed.
Lemma multiple_right : forall n (x y : R), x * multiple n y = multiple n (x * y).
Proof.
  intros n x y. induction n using Z.peano_ind; [apply mul_zero_right | |].
  - rewrite 2!multiple_succ, m_right, IHn. reflexivity.
  - rewrite 2!multiple_pred, m_right, IHn, mul_opp_right. reflexivity.
Qed.

Variables (with_identity : bool) (modulus : Z) (letters : list R).
Hypothesis identity_is : with_identity = true -> has_identity R.
Hypothesis modulus_is : forall x : R, multiple modulus x = 0.
Let letter n : R := if with_identity && Nat.eqb n 0 then 1 else nth n letters 0.
Fixpoint word_value (w : list nat) : R :=
  match w with [] => 1 | [n] => letter n | n :: w => letter n * word_value w end.
Definition value_of (f : words) : R :=
  fold_right (fun t x => multiple (fst t) (word_value (snd t)) + x) 0 f.
Lemma value_cons : forall c w f, value_of ((c, w) :: f) = multiple c (word_value w) + value_of f.
Proof. reflexivity. Qed.
Lemma value_app : forall f g, value_of (f ++ g) = value_of f + value_of g.
Proof.
  intros f g; induction f as [| [c w] f IH]; [symmetry; apply a_zero |].
  change (((c, w) :: f) ++ g) with ((c, w) :: f ++ g). rewrite 2!value_cons, IH. apply a_assoc.
Qed.
Lemma value_by_number : forall c f, value_of (by_number c f) = multiple c (value_of f).
Proof.
  intros c f; induction f as [| [d w] f IH]; [symmetry; apply multiple_zero_of |].
  change (by_number c ((d, w) :: f)) with (((c * d)%Z, w) :: by_number c f).
  rewrite 2!value_cons, IH, multiple_of_sum, multiple_multiple. reflexivity.
Qed.
Lemma value_words : forall v w, v <> [] -> w <> [] -> word_value (v ++ w) = word_value v * word_value w.
Proof.
  intros v w V W; induction v as [| m v IH]; [congruence |].
  destruct v as [| n v].
  - destruct w; [congruence | reflexivity].
  - change (letter m * word_value ((n :: v) ++ w) = letter m * word_value (n :: v) * word_value w).
    rewrite IH by discriminate. apply m_assoc.
Qed.
Lemma value_words_any : with_identity = true -> forall v w, word_value (v ++ w) = word_value v * word_value w.
Proof.
  intros I [| m v] w; [symmetry; apply (identity_is I) |].
  destruct w as [| n w]; [rewrite app_nil_r; symmetry; apply (identity_is I) | apply value_words; discriminate].
Qed.
Lemma value_left : forall v f, not_empty with_identity f = true -> v <> [] ->
  value_of (List.map (fun t => (fst t, v ++ snd t)) f) = word_value v * value_of f.
Proof.
  intros v f E V; unfold not_empty in E. apply orb_true_iff in E.
  induction f as [| [c w] f IH]; [symmetry; apply mul_zero_right |].
  cbn [List.map fst snd]. rewrite 2!value_cons.
  assert (F : with_identity = true \/ forallb (fun t : Z * list nat => match snd t with [] => false | _ => true end) f = true).
  { destruct E as [E | E]; [left; exact E | right]. cbn in E. destruct w; [discriminate | exact E]. }
  specialize (IH F). rewrite IH, m_right. f_equal.
  assert (W : word_value (v ++ w) = word_value v * word_value w).
  { destruct E as [E | E]; [apply value_words_any, E |]. cbn in E. destruct w; [discriminate |].
    apply value_words; [exact V | discriminate]. }
  rewrite W. symmetry. apply multiple_right.
Qed.
Lemma value_right : forall v f, not_empty with_identity f = true -> v <> [] ->
  value_of (List.map (fun t => (fst t, snd t ++ v)) f) = value_of f * word_value v.
Proof.
  intros v f E V; unfold not_empty in E. apply orb_true_iff in E.
  induction f as [| [c w] f IH]; [symmetry; apply mul_zero_left |].
  cbn [List.map fst snd]. rewrite 2!value_cons.
  assert (F : with_identity = true \/ forallb (fun t : Z * list nat => match snd t with [] => false | _ => true end) f = true).
  { destruct E as [E | E]; [left; exact E | right]. cbn in E. destruct w; [discriminate | exact E]. }
  specialize (IH F). rewrite IH, m_left. f_equal.
  assert (W : word_value (w ++ v) = word_value w * word_value v).
  { destruct E as [E | E]; [apply value_words_any, E |]. cbn in E. destruct w; [discriminate |].
    apply value_words; [discriminate | exact V]. }
  rewrite W. symmetry. apply multiple_left.
Qed.
Lemma between_zero : forall f left right, not_empty with_identity f = true -> value_of f = 0 ->
  value_of (between left f right) = 0.
Proof.
  intros f left right E Z.
  assert (B : between left f right = List.map (fun t => (fst t, left ++ snd t)) (List.map (fun t => (fst t, snd t ++ right)) f)).
  { unfold between. rewrite map_map. reflexivity. }
  assert (Zr : value_of (List.map (fun t => (fst t, snd t ++ right)) f) = 0).
  { destruct right as [| n r].
    - rewrite <- Z. f_equal. clear. induction f as [| [c w] f IH]; [reflexivity |].
      cbn [List.map fst snd]. rewrite app_nil_r. f_equal. exact IH.
    - rewrite value_right by (trivial; discriminate). rewrite Z. apply mul_zero_left. }
  assert (Er : not_empty with_identity (List.map (fun t => (fst t, snd t ++ right)) f) = true).
  { unfold not_empty in *. apply orb_true_iff in E. apply orb_true_iff. destruct E as [E | E]; [left; exact E | right].
    clear - E. induction f as [| [c w] f IH]; [reflexivity |]. cbn in *. destruct w; [discriminate |]. cbn. apply IH, E. }
  rewrite B. destruct left as [| n l].
  - rewrite <- Zr. f_equal. rewrite map_map. reflexivity.
  - rewrite value_left by (trivial; discriminate). rewrite Zr. apply mul_zero_right.
Qed.
Hypothesis first_is_one : with_identity = true -> nth 0 letters 0 = 1.
Lemma value_between : forall f v, not_empty with_identity f = true -> (v <> [] \/ with_identity = true) ->
  value_of (between v f []) = word_value v * value_of f.
Proof.
  intros f v E V.
  assert (B : between v f [] = List.map (fun t => (fst t, v ++ snd t)) f).
  { unfold between. apply map_ext. intros [c w]; cbn. rewrite app_nil_r. reflexivity. }
  rewrite B. destruct v as [| n v].
  - destruct V as [V | V]; [congruence |]. cbn [word_value].
    rewrite (proj1 (identity_is V _)). f_equal. clear. induction f as [| [c w] f IH]; [reflexivity |].
    cbn [List.map fst snd app]. f_equal. exact IH.
  - apply value_left; [exact E | discriminate].
Qed.
Lemma words_of_value : forall t, value_of (words_of with_identity t) = letters_value letters t.
Proof.
  induction t; cbn [words_of letters_value].
  - destruct (with_identity && Nat.eqb n 0) eqn:E.
    + apply andb_true_iff in E; destruct E as [E F]. apply Nat.eqb_eq in F; subst n.
      rewrite (first_is_one E). cbn [value_of fold_right fst snd word_value]. rewrite multiple_one, a_comm. apply a_zero.
    + cbn [value_of fold_right fst snd word_value]. unfold letter. rewrite E, multiple_one, a_comm. apply a_zero.
  - reflexivity.
  - rewrite value_by_number, IHt. apply multiple_minus.
  - rewrite value_app, IHt1, IHt2. reflexivity.
  - rewrite value_app, value_by_number, IHt1, IHt2, multiple_minus. symmetry; apply a_sub.
  - rewrite <- IHt1, <- IHt2. clear IHt1. assert (N := words_not_empty with_identity t1). revert N.
    induction (words_of with_identity t1) as [| [c v] f IH]; intro N; cbn [flat_map].
    + symmetry. apply mul_zero_left.
    + rewrite value_app, IH.
      * cbn [fst snd]. rewrite value_by_number, (value_between (words_of with_identity t2) v (words_not_empty with_identity t2)).
        -- change (value_of ((c, v) :: f)) with (multiple c (word_value v) + value_of f).
           rewrite m_left, multiple_left. reflexivity.
        -- exact (proj1 (not_empty_cons _ _ _ _ N)).
      * exact (proj2 (not_empty_cons _ _ _ _ N)).
  - rewrite value_by_number, IHt. reflexivity.
Qed.
Lemma same_word_is : forall v w, same_word v w = true -> v = w.
Proof.
  induction v as [| m v IH]; intros [| n w] E; try discriminate; [reflexivity |].
  cbn in E. apply andb_true_iff in E; destruct E as [E F]. apply Nat.eqb_eq in E. rewrite E, (IH w F). reflexivity.
Qed.
Lemma same_word_refl : forall v, same_word v v = true.
Proof. induction v as [| m v IH]; [reflexivity |]. cbn. rewrite Nat.eqb_refl. exact IH. Qed.
Definition others (w : list nat) (f : words) : words := List.filter (fun t => negb (same_word w (snd t))) f.
Lemma value_apart : forall w f, value_of f = multiple (coefficient w f) (word_value w) + value_of (others w f).
Proof.
  intros w f; induction f as [| [c v] f IH]; [cbn; symmetry; apply a_zero |].
  cbn [others List.filter snd coefficient fold_right fst]. unfold others, coefficient in IH.
  change (value_of ((c, v) :: f)) with (multiple c (word_value v) + value_of f). rewrite IH.
  destruct (same_word w v) eqn:E; cbn [negb].
  - apply same_word_is in E; subst v. rewrite multiple_sum. symmetry. apply eq_sym, a_assoc.
  - change (value_of ((c, v) :: ?g)) with (multiple c (word_value v) + value_of g).
    rewrite 2!a_assoc. f_equal. apply a_comm.
Qed.
Lemma coefficient_others : forall v w f, same_word v w = false -> coefficient v (others w f) = coefficient v f.
Proof.
  intros v w f N; induction f as [| [c u] f IH]; [reflexivity |].
  cbn [others List.filter snd]. destruct (same_word w u) eqn:E; cbn [negb].
  - apply same_word_is in E; subst u. cbn [coefficient fold_right snd fst]. rewrite N. exact IH.
  - cbn [coefficient fold_right snd fst]. unfold others, coefficient in IH. rewrite IH. reflexivity.
Qed.
Lemma multiple_of_modulus : forall c (x : R), divides_by_modulus modulus c = true -> multiple c x = 0.
Proof.
  intros c x E; unfold divides_by_modulus in E. destruct (Z.eqb_spec modulus 0) as [|N].
  - apply Z.eqb_eq in E. rewrite E. reflexivity.
  - apply Z.eqb_eq in E. rewrite (Z.div_mod c modulus N), E, Z.add_0_r, Z.mul_comm, multiple_multiple, modulus_is.
    apply multiple_zero_of.
Qed.
Lemma vanish_zero : forall n f, (length f <= n)%nat -> words_vanish modulus f = true -> value_of f = 0.
Proof.
  induction n as [| n IH]; intros [| [c w] f] L E; try reflexivity; [cbn in L; lia |].
  rewrite (value_apart w). unfold words_vanish in E. rewrite forallb_forall in E.
  rewrite (multiple_of_modulus _ _ (E (c, w) (or_introl eq_refl))), a_zero.
  apply IH.
  - cbn [others List.filter snd]. rewrite same_word_refl. cbn [negb].
    assert (Le : (length (others w f) <= length f)%nat) by (clear; unfold others; induction f as [| t f IH]; cbn; [lia |]; destruct (negb _); cbn; lia).
    unfold others in Le. cbn in L. lia.
  - unfold words_vanish. apply forallb_forall. intros [d v] I. cbn [snd].
    unfold others in I. apply filter_In in I; destruct I as [I D]. cbn [snd] in D.
    change (List.filter (fun t => negb (same_word w (snd t))) ((c, w) :: f)) with (others w ((c, w) :: f)).
    rewrite coefficient_others; [exact (E (d, v) I) |].
    destruct (same_word v w) eqn:F; [| reflexivity]. apply same_word_is in F; subst v.
    rewrite same_word_refl in D. discriminate.
Qed.
Lemma parts_zero : forall rs parts, Forall (fun f => value_of f = 0 /\ not_empty with_identity f = true) rs ->
  value_of (sum_of_parts rs parts) = 0.
Proof.
  intros rs parts F; induction parts as [| [[[c v] n] w] parts IH]; [reflexivity |].
  cbn [sum_of_parts flat_map]. unfold sum_of_parts in IH. rewrite value_app, IH, value_by_number, between_zero.
  - rewrite multiple_zero_of. apply a_zero.
  - destruct (Nat.lt_ge_cases n (length rs)) as [L | L].
    + rewrite Forall_forall in F. apply F, nth_In, L.
    + rewrite nth_overflow by exact L. apply not_empty_nil.
  - destruct (Nat.lt_ge_cases n (length rs)) as [L | L].
    + rewrite Forall_forall in F. apply F, nth_In, L.
    + rewrite nth_overflow by exact L. reflexivity.
Qed.
Lemma difference_zero : forall x y : R, x - y = 0 -> x = y.
Proof.
  intros x y E. rewrite a_sub in E. apply opp_unique in E. rewrite <- (opp_opp x), <- E. apply opp_opp.
Qed.
Lemma equal_difference : forall x y : R, x = y -> x - y = 0.
Proof. intros x y ->. rewrite a_sub. apply a_opp. Qed.
Theorem follows_true : forall relations goal parts, follows with_identity modulus relations goal parts = true ->
  equations_hold letters relations -> letters_value letters (fst goal) = letters_value letters (snd goal).
Proof.
  intros relations goal parts E H. unfold follows in E. apply (vanish_zero _ _ (Nat.le_refl _)) in E.
  rewrite value_app, value_by_number, parts_zero, words_of_value in E.
  - rewrite multiple_zero_of, a_comm, a_zero in E. exact (difference_zero _ _ E).
  - apply Forall_map. revert H. apply Forall_impl. intros e Q. split; [| apply words_not_empty].
    rewrite words_of_value. exact (equal_difference _ _ Q).
Qed.
Theorem all_follow_true : forall relations goals proofs,
  all_follow with_identity modulus relations goals proofs = true ->
  equations_hold letters relations -> equations_hold letters goals.
Proof.
  intros relations goals; induction goals as [| g gs IH]; intros [| p ps] E H; try discriminate; [constructor |].
  cbn [all_follow] in E. apply andb_true_iff in E; destruct E as [E F].
  constructor; [exact (follows_true _ _ _ E H) | exact (IH ps F H)].
Qed.
End Words_are_right.

(* The proposition: relations imply goals, one after the other. *)
Section Says.
Context {R : Type} {operations : Operations R}.
Fixpoint all_equal (letters : list R) (l : list (expression_of_letters * expression_of_letters)) : Prop :=
  match l with
  | [] => True
  | [e] => letters_value letters (fst e) = letters_value letters (snd e)
  | e :: l => letters_value letters (fst e) = letters_value letters (snd e) /\ all_equal letters l
  end.
Fixpoint relations_imply (letters : list R) (l : list (expression_of_letters * expression_of_letters)) (P : Prop) : Prop :=
  match l with
  | [] => P
  | e :: l => letters_value letters (fst e) = letters_value letters (snd e) -> relations_imply letters l P
  end.
Lemma all_equal_is : forall letters l, equations_hold letters l -> all_equal letters l.
Proof.
  intros letters l F; induction F as [| e l E F IH]; [exact I |].
  destruct l; [exact E | split; [exact E | exact IH]].
Qed.
Lemma relations_imply_is : forall letters l (P : Prop), (equations_hold letters l -> P) -> relations_imply letters l P.
Proof.
  intros letters l; induction l as [| e l IH]; intros P F; [apply F; constructor |].
  intro E. apply IH. intro G. apply F. constructor; assumption.
Qed.
End Says.
Definition no_torsion (R : Type) {operations : Operations R} : Prop :=
  forall n (x : R), n <> 0%Z -> multiple n x = 0 -> x = 0.
Theorem presented : forall p relations goals proofs, all_follow true p relations goals proofs = true ->
  every associative ring R with identity, (forall x : R, multiple p x = 0) -> forall i j k : R,
  relations_imply [1; i; j; k] relations (all_equal [1; i; j; k] goals).
Proof.
  intros p relations goals proofs E R operations laws one M i j k.
  apply relations_imply_is. intro H. apply all_equal_is.
  exact (all_follow_true laws true p [1; i; j; k] (fun _ => one) M (fun _ => eq_refl) relations goals proofs E H).
Qed.
Theorem presented_without : forall p relations goals proofs, all_follow false p relations goals proofs = true ->
  every associative ring R, (forall x : R, multiple p x = 0) -> forall e i j k : R,
  relations_imply [e; i; j; k] relations (all_equal [e; i; j; k] goals).
Proof.
  intros p relations goals proofs E R operations laws M e i j k.
  apply relations_imply_is. intro H. apply all_equal_is.
  apply (all_follow_true laws false p [e; i; j; k] ltac:(discriminate) M ltac:(discriminate) relations goals proofs E H).
Qed.
