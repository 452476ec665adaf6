
Section Field.
Context {R : Type} {operations : Operations R} {inverse : Inverse R}.
Variable over : R -> R.
Hypothesis field_laws : field_theory zero one add mul sub opp (fun x y => x * over y) over (@eq R).
Hypothesis equal_or_not : forall x y : R, x = y \/ x <> y.
Let laws := F_R field_laws.
Add Ring judged_ring : laws.
Variables (known : knowledge) (shown : evidence) (st : statement).
Hypothesis modulus_is_zero : num (modulus known) = 0.
Hypothesis units_are : Forall (fun u => unit (num u)) (units known).
Hypothesis rationals : rational known = true -> forall c, c <> 0%Z -> unit (num c).
Hypothesis inverses_are : divides known = true -> forall x y : R, x * y = 1 -> x * inv x = 1.
Hypothesis norm_fact : norm_known known = true ->
  forall q, norm (constants st List.nil) q = 0 -> q = embed 0.
Hypothesis squares_fact : squares_known known = true -> forall terms : list (Z * R),
  Forall (fun t => (0 < fst t)%Z) terms ->
  fold_right (fun t s => num (fst t) * (snd t * snd t) + s) 0 terms = 0 ->
  Forall (fun t => snd t = 0) terms.
Let multiple := multiple_zero laws known modulus_is_zero units_are rationals.
Let number := number_unit laws known modulus_is_zero units_are rationals.
Let prop := proportional_zero laws known modulus_is_zero units_are rationals.
Let prop' := proportional_unit laws known modulus_is_zero units_are rationals.
Let zero_ev := ev_is_zero laws known modulus_is_zero.

Lemma field_inverse : forall x : R, x <> 0 -> x * over x = 1.
Proof. intros x N. rewrite (Rmul_comm laws). exact (Finv_l field_laws x N). Qed.
Lemma unit_iff : forall x : R, unit x <-> x <> 0.
Proof.
  intro x; split.
  - intros [y E] ->. apply (F_1_neq_0 field_laws). rewrite <- E. ring.
  - intro N; exists (over x). exact (field_inverse x N).
Qed.
Lemma no_zero_divisors : forall x y : R, x * y = 0 -> x = 0 \/ y = 0.
Proof.
  intros x y E. destruct (equal_or_not x 0) as [| N]; [left; assumption | right].
  exact (unit_cancel laws x y (proj2 (unit_iff x) N) E).
Qed.
Lemma power_zero : forall l f n, ev l (power f n) = 0 -> ev l f = 0.
Proof.
  intros l f n; induction n as [| n IH]; cbn [power]; intro E.
  - elim (F_1_neq_0 field_laws). exact E.
  - rewrite (ev_mul laws) in E. apply no_zero_divisors in E. destruct E; [assumption | apply IH; assumption].
Qed.

Let ns := List.map (fun c => Pc c) (numbers shown).
Hypothesis numbers_are : forallb (number_is_unit known) (numbers shown) = true.
Lemma numbers_units : forall l, Forall (fun f => unit (ev l f)) ns.
Proof.
  intro l. unfold ns. apply Forall_map, Forall_forall. intros c I.
  rewrite forallb_forall in numbers_are. exact (number c (numbers_are c I)).
Qed.
Let form := norm_form known st ns.
Fixpoint steps_sound (l : list R) (s : steps) {struct s} : forall zs,
  run known form s zs = true -> Forall (fun f => ev l f = 0) zs -> False.
Proof.
  destruct s as [cs d | [a b c d] cs rest | terms cs rest | factors cs d branches];
    intros zs E Z; cbn [run] in E.
  - apply (F_1_neq_0 field_laws). exact (multiple l _ _ _ E (sum_of_zeros laws l zs cs Z)).
  - repeat (apply andb_true_iff in E; destruct E as [E ?]).
    assert (N := norm_stands laws known modulus_is_zero inverses_are st l ns (numbers_units l)
      (read a) (read b) (read c) (read d)).
    assert (X : norm (constants st List.nil) (Quaternion (ev l (read a)) (ev l (read b)) (ev l (read c)) (ev l (read d))) = 0).
    { apply (zero_top laws l ns (numbers_units l) _ _ N); [assumption |].
      exact (prop _ _ l H0 (sum_of_zeros laws l zs cs Z)). }
    apply (norm_fact E) in X. injection X as X0 X1 X2 X3.
    apply (steps_sound l rest _ H). apply Forall_app. split; [exact Z |].
    repeat constructor; assumption.
  - repeat (apply andb_true_iff in E; destruct E as [E ?]).
    apply (steps_sound l rest _ H). apply Forall_app. split; [exact Z |].
    rewrite forallb_forall in H1.
    assert (X := squares_fact E (List.map (fun t => (fst t, ev l (read (snd t)))) terms)).
    assert (Y : forall ts, ev l (fold_right (fun t f => padd (times (fst t) (pmul (snd t) (snd t))) f) (Pc 0%Z)
       (List.map (fun t => (fst t, read (snd t))) ts)) =
       fold_right (fun t s => num (fst t) * (snd t * snd t) + s) 0 (List.map (fun t => (fst t, ev l (read (snd t)))) ts)).
    { induction ts as [| t ts IH]; [reflexivity |]. cbn [List.map fold_right fst snd].
      rewrite (ev_add laws), (ev_times laws), (ev_mul laws), IH. reflexivity. }
    rewrite <- Y in X. rewrite map_map. apply Forall_map.
    assert (W : Forall (fun t : BinNums.Z * R => snd t = 0) (List.map (fun t => (fst t, ev l (read (snd t)))) terms)).
    { apply X.
      - apply Forall_map, Forall_forall. intros t I. cbn [fst].
        specialize (H1 (fst t, read (snd t)) (in_map _ _ _ I)). apply Z.ltb_lt in H1. exact H1.
      - exact (prop _ _ l H0 (sum_of_zeros laws l zs cs Z)). }
    exact (proj1 (Forall_map _ _ _) W).
  - apply andb_true_iff in E; destruct E as [E H]. apply andb_true_iff in E; destruct E as [E H0].
    apply Nat.eqb_eq in H0.
    assert (P : ev l (fold_right (fun t f => pmul (power (fst t) (snd t)) f) (Pc 1%Z)
      (List.map (fun t => (read (fst t), snd t)) factors)) = 0)
      by exact (multiple l _ _ _ E (sum_of_zeros laws l zs cs Z)).
    revert H H0 P. generalize (List.map (fun t => (read (fst t), snd t)) factors). clear E.
    induction branches as [| s branches IH]; intros [| f fs] H W P; try discriminate W.
    + apply (F_1_neq_0 field_laws). exact P.
    + apply andb_true_iff in H; destruct H as [H0 H1].
      cbn [fold_right] in P. rewrite (ev_mul laws) in P. apply no_zero_divisors in P. destruct P as [P | P].
      * apply (steps_sound l s _ H0). apply Forall_app; split; [exact Z |].
        constructor; [exact (power_zero _ _ _ P) | constructor].
      * injection W as W. exact (IH fs H1 W P).
Qed.

Lemma ev_inverses : forall l vs,
  Forall2 (fun f x => ev (vs ++ l) f = x) (inverses (length vs)) vs.
Proof.
  intros l vs; induction vs as [| v vs IH]; cbn [inverses length app]; constructor.
  - rewrite (ev_variable laws). reflexivity.
  - revert IH. generalize (inverses (length vs)). intros fs F.
    assert (G : forall fs xs, Forall2 (fun f x => ev (vs ++ l) f = x) fs xs ->
      Forall2 (fun f x => ev (List.cons v (vs ++ l)) f = x) (List.map (mkPinj 1) fs) xs).
    { clear. intros fs xs F; induction F; constructor; [| assumption]. rewrite ev_shift. assumption. }
    exact (G _ _ F).
Qed.
Lemma ev_past : forall l (vs : list R) f, ev (vs ++ l) (after (length vs) f) = ev l f.
Proof.
  intros l vs f; induction vs as [| v vs IH]; [reflexivity |]. cbn [after length app].
  rewrite ev_shift. exact IH.
Qed.
Lemma excluded_sound : forall l zeros nonzeros script,
  is_sound known form (Excluded zeros nonzeros script) = true ->
  Forall (fun f => ev l (read f) = 0) zeros -> Forall (fun f => ev l (read f) <> 0) nonzeros -> False.
Proof.
  intros l zeros nonzeros script E Z N. cbn [is_sound] in E.
  set (vs := List.map (fun f => over (ev l (read f))) nonzeros).
  assert (W : length nonzeros = length vs) by (symmetry; apply map_length).
  rewrite W in E. apply (steps_sound (vs ++ l) script _ E). apply Forall_app; split.
  - apply Forall_map. revert Z. apply Forall_impl. intros f F. rewrite ev_past. exact F.
  - assert (G : forall ts n l', (forall f, ev l' (after n f) = ev l f) ->
      Forall2 (fun f x => ev l' f = x) ts (List.map (fun f => over (ev l (read f))) nonzeros) ->
      Forall (fun f => ev l' f = 0) (List.map (fun p => psub (Pc 1%Z) (pmul (fst p) (after n (read (snd p)))))
        (combine ts nonzeros))).
    { clear - N laws field_laws. induction N as [| f fs N F IH]; intros ts n l' P I; cbn [List.map] in I.
      - destruct ts; constructor.
      - inversion I as [| t x ts' xs E I' X Y]; subst. cbn [combine List.map fst snd]. constructor.
        + rewrite (ev_sub laws), (ev_mul laws), P, E.
          change (ev l' (Pc 1%Z)) with (1 : R). rewrite (Rmul_comm laws), (field_inverse _ N). ring.
        + apply (IH _ _ _ P I'). }
    apply G; [intro f; apply ev_past | apply ev_inverses].
Qed.

Section Places.
Variables (qs : list (quaternion R)) (ss : list R).
Hypothesis width_q : length qs = quaternions st.
Hypothesis width_s : length ss = scalars st.
Let l := coordinates_of qs ss.
Let A := constants st ss.
Hypothesis relations_hold : Forall (fun r => ev l (read r) = 0) (relations known).
Hypothesis sound : forallb (is_sound known form) (items shown) = true.
Let vanishing := vanishes_zero laws known shown modulus_is_zero units_are rationals l relations_hold.
Let plain := plainly laws known shown modulus_is_zero units_are rationals l relations_hold.

Section Place.
Variables zs fs : list polynomial.
Hypothesis zs_zero : Forall (fun f => ev l f = 0) zs.
Hypothesis fs_not : Forall (fun f => ev l f <> 0) fs.
Lemma plain_nonzero : forall f, plainly_nonzero known fs f = true -> ev l f <> 0.
Proof.
  intros f E Z. apply existsb_exists in E; destruct E as [g [I E]].
  rewrite Forall_forall in fs_not. apply (fs_not g I), (prop' _ _ _ E), Z.
Qed.
Lemma strip_product : forall ds g, Forall (fun d => ev l (read d) <> 0) ds ->
  ev l (fold_right (fun d h => pmul (read d) h) (read g) ds) = 0 -> ev l (read g) = 0.
Proof.
  intros ds g F; induction F as [| d ds N F IH]; intro E; [exact E |].
  cbn [fold_right] in E. rewrite (ev_mul laws) in E. apply no_zero_divisors in E.
  destruct E as [E | E]; [elim (N E) | exact (IH E)].
Qed.
Lemma product_strip : forall ds g, ev l (read g) = 0 ->
  ev l (fold_right (fun d h => pmul (read d) h) (read g) ds) = 0.
Proof.
  intros ds g E; induction ds as [| d ds IH]; [exact E |].
  cbn [fold_right]. rewrite (ev_mul laws), IH. ring.
Qed.
Lemma zero_by_hint_sound : forall f, zero_by_hint known shown zs fs f = true -> ev l f = 0.
Proof.
  intros f E; unfold zero_by_hint in E. apply orb_true_iff in E; destruct E as [E | E].
  - exact (plain zs f zs_zero E).
  - apply existsb_exists in E; destruct E as [[[h ds] g] [I E]]. apply filter_In in I; destruct I as [_ I].
    apply andb_true_iff in E; destruct E as [E D]. apply andb_true_iff in E; destruct E as [E P].
    apply (prop _ _ _ E). apply (strip_product ds).
    + apply Forall_forall. intros d J. rewrite forallb_forall in D. exact (plain_nonzero _ (D d J)).
    + apply (prop _ _ _ I). exact (plain zs _ zs_zero P).
Qed.
Lemma known_zero_sound : forall f, known_zero known shown zs fs f = true -> ev l f = 0.
Proof.
  intros f E; unfold known_zero in E. apply orb_true_iff in E; destruct E as [E | E].
  - exact (zero_by_hint_sound f E).
  - apply existsb_exists in E; destruct E as [[[h ds] g] [I E]]. apply filter_In in I; destruct I as [_ I].
    apply andb_true_iff in E; destruct E as [E P]. apply (prop _ _ _ E), (prop' _ _ _ I), product_strip.
    exact (zero_by_hint_sound _ P).
Qed.
Lemma nonzero_by_hint_sound : forall f, nonzero_by_hint known shown fs f = true -> ev l f <> 0.
Proof.
  intros f E Z; unfold nonzero_by_hint in E. apply orb_true_iff in E; destruct E as [E | E].
  - apply orb_true_iff in E; destruct E as [E | E].
    + exact (plain_nonzero f E Z).
    + destruct f as [c | |]; try discriminate. apply number, unit_iff in E. exact (E Z).
  - apply existsb_exists in E; destruct E as [[[h ds] g] [I E]]. apply filter_In in I; destruct I as [_ I].
    apply andb_true_iff in E; destruct E as [E P]. apply (plain_nonzero _ P).
    apply (prop' _ _ _ I), product_strip, (prop' _ _ _ E), Z.
Qed.
Lemma known_nonzero_sound : forall f, known_nonzero known shown fs f = true -> ev l f <> 0.
Proof.
  intros f E Z; unfold known_nonzero in E. apply orb_true_iff in E; destruct E as [E | E].
  - exact (nonzero_by_hint_sound f E Z).
  - apply existsb_exists in E; destruct E as [[[h ds] g] [I E]]. apply filter_In in I; destruct I as [_ I].
    apply andb_true_iff in E; destruct E as [E D]. apply andb_true_iff in E; destruct E as [E P].
    apply (nonzero_by_hint_sound _ P). apply (strip_product ds).
    + apply Forall_forall. intros d J. rewrite forallb_forall in D. exact (plain_nonzero _ (D d J)).
    + apply (prop _ _ _ I), (prop' _ _ _ E), Z.
Qed.
Lemma all_known_zero : forall gs, forallb (known_zero known shown zs fs) (List.map read gs) = true ->
  Forall (fun g => ev l (read g) = 0) gs.
Proof.
  intros gs E. rewrite forallb_forall in E. apply Forall_forall. intros g I.
  apply known_zero_sound, E, in_map, I.
Qed.
Lemma closed_sound : closed known shown zs fs = true -> False.
Proof.
  intro E; unfold closed in E. apply orb_true_iff in E; destruct E as [E | E];
    [apply orb_true_iff in E; destruct E as [E | E] |].
  - apply existsb_exists in E; destruct E as [z [I E]]. destruct z as [c | |]; try discriminate.
    rewrite Forall_forall in zs_zero. apply number, unit_iff in E. exact (E (zs_zero _ I)).
  - apply existsb_exists in E; destruct E as [f [I E]].
    assert (N := fs_not). rewrite Forall_forall in N. exact (N f I (known_zero_sound f E)).
  - apply existsb_exists in E; destruct E as [i [I E]].
    assert (S := sound). rewrite forallb_forall in S. specialize (S i I).
    destruct i as [zeros f cs d | zeros nonzeros script]; cbn [excludes] in E;
      apply andb_true_iff in E; destruct E as [Z N]; apply all_known_zero in Z.
    + apply (known_nonzero_sound _ N).
      exact (direct_sound laws known modulus_is_zero units_are rationals l _ _ _ _ _ S Z).
    + apply (excluded_sound l _ _ _ S Z). apply Forall_forall. intros f J.
      apply known_nonzero_sound. rewrite forallb_forall in N. apply N, in_map, J.
Qed.
End Place.

Lemma decidable_formula : forall f, holds A qs ss f \/ ~ holds A qs ss f.
Proof.
  induction f; cbn [holds]; try tauto.
  - destruct (equal_or_not (scalar_value A qs ss x) (scalar_value A qs ss y)); tauto.
  - destruct (quat_value A qs ss p) as [a b c d], (quat_value A qs ss q) as [a' b' c' d'].
    destruct (equal_or_not a a') as [-> |]; [| right; congruence].
    destruct (equal_or_not b b') as [-> |]; [| right; congruence].
    destruct (equal_or_not c c') as [-> |]; [| right; congruence].
    destruct (equal_or_not d d') as [-> |]; [left; reflexivity | right; congruence].
  - destruct (equal_or_not (scalar_value A qs ss x) 0) as [E | N].
    + right. intro U. exact (proj1 (unit_iff _) U E).
    + left. exact (proj2 (unit_iff _) N).
Qed.
Definition assumed (a : bool * formula) : Prop :=
  if fst a then holds A qs ss (snd a) else ~ holds A qs ss (snd a).
Lemma units_of : forall fs, Forall (fun f => ev l f <> 0) fs -> Forall (fun f => unit (ev l f)) fs.
Proof. intros fs. apply Forall_impl. intros f N. apply unit_iff, N. Qed.
Let difference_of := difference_stands laws known modulus_is_zero inverses_are st qs ss width_q width_s l eq_refl.
Let differences_of := differences_stand laws known modulus_is_zero inverses_are st qs ss width_q width_s l eq_refl.
Lemma refuted_sound : forall fuel todo zs fs,
  refuted known shown (evaluate known st) (evaluate_quat known st) fuel todo zs fs = true ->
  Forall (fun f => ev l f = 0) zs -> Forall (fun f => ev l f <> 0) fs -> Forall assumed todo -> False.
Proof.
  induction fuel as [| fuel IH]; intros todo zs fs E Z N T; [destruct todo; discriminate E |].
  destruct todo as [| [sign f] rest]; [exact (closed_sound zs fs Z N E) |].
  inversion_clear T as [| ? ? T0 T1].
  assert (apart : forall d x, stands_for l fs d x -> x <> 0 ->
    (if valid d then vanishes known shown (top d) ||
       refuted known shown (evaluate known st) (evaluate_quat known st) fuel rest zs (fs ++ List.cons (top d) List.nil)
     else refuted known shown (evaluate known st) (evaluate_quat known st) fuel rest zs fs) = true -> False).
  { intros d x S X F. destruct (valid d) eqn:V; [| exact (IH _ _ _ F Z N T1)].
    assert (Y : ev l (top d) <> 0).
    { intro Y. exact (X (zero_top laws l fs (units_of fs N) d x S V Y)). }
    apply orb_true_iff in F; destruct F as [F | F]; [exact (Y (vanishing _ F)) |].
    apply (IH _ _ _ F Z); [| exact T1]. apply Forall_app. split; [exact N |]. repeat constructor. exact Y. }
  cbn [refuted] in E. unfold assumed in T0; cbn [fst snd] in T0.
  destruct f as [x y | p q | x | f | f g | f g | f g | f g]; destruct sign; cbn [holds] in T0;
    try match type of E with (_ && _)%bool = true => apply andb_true_iff in E; destruct E as [E H] end.
  - apply (IH _ _ _ E); [| exact N | exact T1]. apply Forall_app. split; [| exact Z].
    apply (tops_zero laws l fs _ _ (Forall2_cons _ _ (difference_of fs (units_of fs N) x y) (Forall2_nil _))).
    repeat constructor. apply (zero_of_equal laws), T0.
  - apply (apart _ _ (difference_of fs (units_of fs N) x y)); [| exact E].
    intro X. apply T0, (minus_zero laws), X.
  - apply (IH _ _ _ E); [| exact N | exact T1]. apply Forall_app. split; [| exact Z].
    apply (tops_zero laws l fs _ _ (differences_of fs (units_of fs N) p q)).
    destruct (qsub_of_equal laws _ _ T0) as [? [? [? ?]]]. repeat constructor; assumption.
  - assert (D := differences_of fs (units_of fs N) p q). cbv zeta in D.
    unfold differences in E, D. cbn [forallb] in E.
    apply andb_true_iff in E; destruct E as [E0 E]. apply andb_true_iff in E; destruct E as [E1 E].
    apply andb_true_iff in E; destruct E as [E2 E]. apply andb_true_iff in E; destruct E as [E3 E].
    inversion_clear D as [| ? ? ? ? D0 D']. inversion_clear D' as [| ? ? ? ? D1 D''].
    inversion_clear D'' as [| ? ? ? ? D2 D3']. inversion_clear D3' as [| ? ? ? ? D3 ?].
    destruct (equal_or_not (re (qsub (quat_value A qs ss p) (quat_value A qs ss q))) 0) as [X0 | X]; [| exact (apart _ _ D0 X E0)].
    destruct (equal_or_not (im (qsub (quat_value A qs ss p) (quat_value A qs ss q))) 0) as [X1 | X]; [| exact (apart _ _ D1 X E1)].
    destruct (equal_or_not (jm (qsub (quat_value A qs ss p) (quat_value A qs ss q))) 0) as [X2 | X]; [| exact (apart _ _ D2 X E2)].
    destruct (equal_or_not (km (qsub (quat_value A qs ss p) (quat_value A qs ss q))) 0) as [X3 | X]; [| exact (apart _ _ D3 X E3)].
    apply T0. apply (equal_of_qsub laws); assumption.
  - exact (IH _ _ _ E Z N T1).
  - exact (IH _ _ _ E Z N T1).
  - apply (IH _ _ _ E Z N). constructor; [exact T0 | exact T1].
  - apply (IH _ _ _ E Z N). constructor; [| exact T1]. unfold assumed; cbn.
    destruct (decidable_formula f); tauto.
  - apply (IH _ _ _ E Z N). repeat constructor; try exact T1; apply T0.
  - destruct (decidable_formula f) as [F | F].
    + apply (IH _ _ _ H Z N). repeat constructor; try exact T1; unfold assumed; cbn; tauto.
    + apply (IH _ _ _ E Z N). repeat constructor; try exact T1; unfold assumed; cbn; tauto.
  - destruct (decidable_formula f) as [F | F].
    + apply (IH _ _ _ E Z N). repeat constructor; try exact T1; unfold assumed; cbn; tauto.
    + apply (IH _ _ _ H Z N). repeat constructor; try exact T1; unfold assumed; cbn; tauto.
  - apply (IH _ _ _ E Z N). repeat constructor; try exact T1; unfold assumed; cbn; tauto.
  - destruct (decidable_formula f) as [F | F].
    + apply (IH _ _ _ H Z N). repeat constructor; try exact T1; unfold assumed; cbn; tauto.
    + apply (IH _ _ _ E Z N). repeat constructor; try exact T1; unfold assumed; cbn; tauto.
  - apply (IH _ _ _ E Z N). destruct (decidable_formula f), (decidable_formula g);
      repeat constructor; try exact T1; unfold assumed; cbn; tauto.
  - destruct (decidable_formula f) as [F | F].
    + apply (IH _ _ _ E Z N). repeat constructor; try exact T1; unfold assumed; cbn; tauto.
    + apply (IH _ _ _ H Z N). repeat constructor; try exact T1; unfold assumed; cbn; tauto.
  - destruct (decidable_formula f) as [F | F].
    + apply (IH _ _ _ E Z N). repeat constructor; try exact T1; unfold assumed; cbn; tauto.
    + apply (IH _ _ _ H Z N). destruct (decidable_formula g);
        repeat constructor; try exact T1; unfold assumed; cbn; tauto.
Qed.
Lemma imply_unless : forall hs (P : Prop), (Forall (fun h => holds A qs ss h) hs -> P) -> hold_imply A qs ss hs P.
Proof.
  induction hs as [| h hs IH]; intros P F; [apply F; constructor |].
  intro H. apply IH. intro G. apply F. constructor; assumption.
Qed.
End Places.
Theorem judged_true :
  (forall l, Forall (fun r => ev l (read r) = 0) (relations known)) ->
  judged known shown st = true -> says st.
Proof.
  intros relations_hold E. unfold judged in E.
  apply andb_true_iff in E; destruct E as [E X]. apply andb_true_iff in E; destruct E as [E S].
  apply andb_true_iff in E; destruct E as [E F1]. apply andb_true_iff in E; destruct E as [E F0].
  apply Nat.eqb_eq in F0, F1.
  apply same_for_all; intros qs Wq. apply same_for_all; intros ss Ws. apply none_more; trivial.
  apply imply_unless. intro G. destruct (decidable_formula qs ss (conclusion st)) as [H | H]; [exact H |].
  exfalso. apply (refuted_sound qs ss Wq Ws (relations_hold _) S enough _ _ _ X).
  - constructor.
  - fold ns. assert (U := numbers_units (coordinates_of qs ss)). revert U. apply Forall_impl.
    intros f U. apply unit_iff, U.
  - apply Forall_app. split; [apply Forall_map; exact G | repeat constructor; exact H].
Qed.
End Field.

Theorem judged_says : forall {R} {operations : Operations R} {inverse : Inverse R} (over : R -> R),
  field_theory zero one add mul sub opp (fun x y => mul x (over y)) over (@eq R) ->
  (forall x y : R, x = y \/ x <> y) -> forall known shown st,
  num (modulus known) = zero -> Forall (fun u => unit (num u)) (units known) ->
  (rational known = true -> forall c, c <> 0%Z -> unit (num c)) ->
  (divides known = true -> forall x y : R, mul x y = one -> mul x (inv x) = one) ->
  (norm_known known = true -> forall q, norm (constants st List.nil) q = zero -> q = embed zero) ->
  (squares_known known = true -> forall terms : list (Z * R), Forall (fun t => (0 < fst t)%Z) terms ->
    fold_right (fun t s => add (mul (num (fst t)) (mul (snd t) (snd t))) s) zero terms = zero ->
    Forall (fun t => snd t = zero) terms) ->
  (forall l, Forall (fun r => ev l (read r) = zero) (relations known)) ->
  judged known shown st = true -> says st.
Proof.
  intros R operations inverse over F D known shown st M U Q I N S L E.
  assert (C : forallb (number_is_unit known) (numbers shown) = true).
  { unfold judged in E. repeat (apply andb_true_iff in E; destruct E as [E _]). exact E. }
  exact (judged_true over F D known shown st M U Q I N S C L E).
Qed.
