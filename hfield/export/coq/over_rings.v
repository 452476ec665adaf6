
(* The symbols of a statement, and what is computed with them. *)
Section Symbols.
Variables (known : knowledge) (st : statement).
Definition symbols_q := List.map as_fractions (quaternion_symbols (quaternions st)).
Definition symbols_s :=
  List.map (fun f => polynomial_fraction (after (4 * quaternions st) f)) (scalar_symbols (scalars st)).
Definition evaluate ns (x : scalar) : fraction :=
  scalar_value (operations := fractions known ns) (inverse := reciprocal known ns)
    (constants (operations := fractions known ns) (inverse := reciprocal known ns) st symbols_s)
    symbols_q symbols_s x.
Definition evaluate_quat ns (q : quat) : quaternion fraction :=
  quat_value (operations := fractions known ns) (inverse := reciprocal known ns)
    (constants (operations := fractions known ns) (inverse := reciprocal known ns) st symbols_s)
    symbols_q symbols_s q.
Definition norm_form ns a b c d : fraction :=
  norm (operations := fractions known ns)
    (constants (operations := fractions known ns) (inverse := reciprocal known ns) st List.nil)
    (as_fractions (Quaternion a b c d)).
End Symbols.
Definition enough : nat := Nat.pow 2 14.
(* Over a field. *)
Definition judged (known : knowledge) (shown : evidence) (st : statement) : bool :=
  let ns := List.map (fun c => Pc c) (numbers shown) in
  forallb (number_is_unit known) (numbers shown) &&
  Nat.eqb (found_quaternions st) 0 && Nat.eqb (found_scalars st) 0 &&
  forallb (is_sound known (norm_form known st ns)) (items shown) &&
  refuted known shown (evaluate known st) (evaluate_quat known st) enough
    (List.map (pair true) (given st) ++ List.cons (false, conclusion st) List.nil) List.nil ns.
(* Over a commutative ring. *)
Definition judged_directly (known : knowledge) (shown : evidence) (st : statement) : bool :=
  let none := fun _ _ _ _ => polynomial_fraction (Pc 0%Z) in
  Nat.eqb (found_quaternions st) 0 && Nat.eqb (found_scalars st) 0 && negb (divides known) &&
  forallb (is_sound known none) (items shown) &&
  derived known shown (evaluate known st) (evaluate_quat known st) List.nil
    (fold_right Imp (conclusion st) (given st)).

Section Soundness.
Context {R : Type} {operations : Operations R} {inverse : Inverse R}.
Hypothesis laws : ring_theory zero one add mul sub opp (@eq R).
Add Ring soundness_ring : laws.
Variables (known : knowledge) (shown : evidence).
Hypothesis modulus_is_zero : num (modulus known) = 0.
Hypothesis units_are : Forall (fun u => unit (num u)) (units known).
Hypothesis rationals : rational known = true -> forall c, c <> 0%Z -> unit (num c).
Hypothesis inverses_are : divides known = true -> forall x y, x * y = 1 -> x * inv x = 1.
Let multiple := multiple_zero laws known modulus_is_zero units_are rationals.
Let number := number_unit laws known modulus_is_zero units_are rationals.
Let prop := proportional_zero laws known modulus_is_zero units_are rationals.
Let prop' := proportional_unit laws known modulus_is_zero units_are rationals.
Let zero_ev := ev_is_zero laws known modulus_is_zero.

Lemma same_for_all : forall T n (P : list T -> Prop),
  (forall l, length l = n -> P l) -> for_all n P.
Proof.
  induction n as [| n IH]; intros P F; [apply F; reflexivity |].
  intro x. apply IH. intros l E. apply F. cbn. congruence.
Qed.

Section At.
Variables (st : statement) (qs : list (quaternion R)) (ss : list R).
Hypothesis width_q : length qs = quaternions st.
Hypothesis width_s : length ss = scalars st.
Variable l : list R.
Hypothesis l_is : l = coordinates_of qs ss.
Let A := constants st ss.
Hypothesis relations_hold : Forall (fun r => ev l (read r) = 0) (relations known).

Section Terms.
Variable ns : list polynomial.
Hypothesis units_ns : Forall (fun f => unit (ev l f)) ns.
Let stands := stands_for l ns.
Lemma symbols_s_stand : Forall2 stands (symbols_s st) ss.
Proof.
  unfold symbols_s. rewrite <- width_s, <- width_q.
  assert (E := scalar_symbols_are laws ss).
  induction E as [| f x fs xs E F IH]; cbn [List.map]; constructor; [| exact IH].
  replace x with (ev l (after (4 * length qs) f)).
  - apply (stands_polynomial laws).
  - rewrite l_is, ev_after. exact E.
Qed.
Lemma symbols_q_stand : Forall2 (qrel stands) (symbols_q st) qs.
Proof.
  unfold symbols_q. rewrite <- width_q. assert (E := quaternion_symbols_are laws qs ss).
  induction E as [| f x fs xs [E0 [E1 [E2 E3]]] F IH]; cbn [List.map]; constructor; [| exact IH].
  unfold qrel, as_fractions; cbn [re im jm km]. rewrite <- l_is in E0, E1, E2, E3.
  rewrite <- E0, <- E1, <- E2, <- E3. repeat split; apply (stands_polynomial laws).
Qed.
Let r0 : stands (zero (Operations := fractions known ns)) 0 := stands_polynomial laws l ns (Pc 0%Z).
Let r1 : stands (one (Operations := fractions known ns)) 1 := stands_polynomial laws l ns (Pc 1%Z).
Let ra : forall f x g y, stands f x -> stands g y -> stands (add (Operations := fractions known ns) f g) (x + y)
  := stands_add laws known modulus_is_zero l ns units_ns.
Let rs : forall f x g y, stands f x -> stands g y -> stands (sub (Operations := fractions known ns) f g) (x - y)
  := stands_sub laws known modulus_is_zero l ns units_ns.
Let rm : forall f x g y, stands f x -> stands g y -> stands (mul (Operations := fractions known ns) f g) (x * y)
  := stands_mul laws known modulus_is_zero l ns units_ns.
Let ro : forall f x, stands f x -> stands (opp (Operations := fractions known ns) f) (- x)
  := stands_opp laws known l ns.
Let ri : forall f x, stands f x -> stands (reciprocal known ns f) (inv x)
  := stands_inv laws known modulus_is_zero l ns units_ns inverses_are.
Lemma scalars_stand : forall B B' ps ps' xs xs', arel stands B B' -> Forall2 (qrel stands) ps ps' ->
  Forall2 stands xs xs' -> forall x,
  stands (scalar_value (operations := fractions known ns) (inverse := reciprocal known ns) B ps xs x)
         (scalar_value B' ps' xs' x).
Proof.
  intros B B' ps ps' xs xs' a p x.
  exact (proj1 (rel_terms stands r0 r1 ra rs rm ro ri B B' a ps ps' xs xs' p x)).
Qed.
Lemma quats_stand : forall B B' ps ps' xs xs', arel stands B B' -> Forall2 (qrel stands) ps ps' ->
  Forall2 stands xs xs' -> forall q,
  qrel stands (quat_value (operations := fractions known ns) (inverse := reciprocal known ns) B ps xs q)
         (quat_value B' ps' xs' q).
Proof.
  intros B B' ps ps' xs xs' a p x.
  exact (proj2 (rel_terms stands r0 r1 ra rs rm ro ri B B' a ps ps' xs xs' p x)).
Qed.
Lemma hamilton_stands : arel stands (Hamilton (operations := fractions known ns)) Hamilton.
Proof. repeat split; try apply r0; apply ro, r1. Qed.
Lemma constants_stand : forall xs xs', Forall2 stands xs xs' -> arel stands
  (constants (operations := fractions known ns) (inverse := reciprocal known ns) st xs) (constants st xs').
Proof.
  intros xs xs' x; repeat split; (apply scalars_stand; [apply hamilton_stands | constructor | exact x]).
Qed.
Lemma evaluate_stands : forall x, stands (evaluate known st ns x) (scalar_value A qs ss x).
Proof.
  apply scalars_stand; [apply constants_stand | apply symbols_q_stand |]; apply symbols_s_stand.
Qed.
Lemma evaluate_quat_stands : forall q, qrel stands (evaluate_quat known st ns q) (quat_value A qs ss q).
Proof.
  apply quats_stand; [apply constants_stand | apply symbols_q_stand |]; apply symbols_s_stand.
Qed.
Lemma norm_stands : forall a b c d, stands (norm_form known st ns a b c d)
  (norm (constants st List.nil) (Quaternion (ev l a) (ev l b) (ev l c) (ev l d))).
Proof.
  intros. apply (rel_norm stands ra rs rm); [apply constants_stand; constructor |].
  repeat split; apply (stands_polynomial laws l ns).
Qed.
Lemma top_zero : forall f, stands f 0 -> valid f = true -> ev l (top f) = 0.
Proof. intros f S V. rewrite <- (S V). ring. Qed.
Lemma zero_top : forall f x, stands f x -> valid f = true -> ev l (top f) = 0 -> x = 0.
Proof.
  intros f x S V Z. rewrite <- (S V) in Z.
  apply (unit_cancel laws _ x (product_units laws l ns units_ns (below f))). rewrite <- Z. ring.
Qed.
Lemma difference_stands : forall x y,
  stands (difference known (evaluate known st) ns x y) (scalar_value A qs ss x - scalar_value A qs ss y).
Proof. intros. apply rs; apply evaluate_stands. Qed.
Lemma differences_stand : forall p q,
  let d := qsub (quat_value A qs ss p) (quat_value A qs ss q) in
  Forall2 stands (differences known (evaluate_quat known st) ns p q)
    (List.cons (re d) (List.cons (im d) (List.cons (jm d) (List.cons (km d) List.nil)))).
Proof.
  intros p q d.
  destruct (evaluate_quat_stands p) as [? [? [? ?]]], (evaluate_quat_stands q) as [? [? [? ?]]].
  repeat constructor; apply rs; assumption.
Qed.
End Terms.
Lemma zero_of_equal : forall x y : R, x = y -> x - y = 0.
Proof. intros x y ->. ring. Qed.
Lemma qsub_of_equal : forall p q : quaternion R, p = q -> let d := qsub p q in
  re d = 0 /\ im d = 0 /\ jm d = 0 /\ km d = 0.
Proof. intros p q -> d. repeat split; cbn; ring. Qed.
Lemma equal_of_qsub : forall p q : quaternion R, let d := qsub p q in
  re d = 0 -> im d = 0 -> jm d = 0 -> km d = 0 -> p = q.
Proof. intros p q d E0 E1 E2 E3. apply coordinates; apply (minus_zero laws); assumption. Qed.
Lemma tops_zero : forall ns fs xs, Forall2 (stands_for l ns) fs xs -> Forall (fun x => x = 0) xs ->
  Forall (fun f => ev l f = 0) (tops fs).
Proof.
  intros ns fs xs F; induction F as [| f x fs xs E F IH]; intro Z; [constructor |].
  inversion_clear Z as [| ? ? Z0 Z1]. unfold tops; cbn [List.filter].
  destruct (valid f) eqn:V; [constructor |]; [rewrite <- (E V), Z0; ring | |]; apply IH, Z1.
Qed.
Lemma vanishes_zero : forall f, vanishes known shown f = true -> ev l f = 0.
Proof.
  intros f E; unfold vanishes in E. apply orb_true_iff in E; destruct E as [E | E].
  - apply zero_ev, E.
  - apply existsb_exists in E; destruct E as [[g cs] [_ E]]. cbn [fst snd] in E.
    apply andb_true_iff in E; destruct E as [P E]. apply (prop _ _ _ P).
    apply zero_ev with (l := l) in E. rewrite (ev_sub laws) in E. apply (minus_zero laws) in E.
    rewrite E. apply (sum_of_zeros laws), Forall_map, relations_hold.
Qed.

(* Direct items, and what they derive over any commutative ring. *)
Lemma direct_sound : forall form zeros f cs d, is_sound known form (Direct zeros f cs d) = true ->
  Forall (fun z => ev l (read z) = 0) zeros -> ev l (read f) = 0.
Proof.
  intros form zeros f cs d E Z. apply (multiple l _ _ _ E), (sum_of_zeros laws), Forall_map, Z.
Qed.
Lemma plainly : forall zs f, Forall (fun z => ev l z = 0) zs ->
  plainly_zero known shown zs f = true -> ev l f = 0.
Proof.
  intros zs f Z E; unfold plainly_zero in E. apply orb_true_iff in E; destruct E as [E | E].
  - apply vanishes_zero, E.
  - apply existsb_exists in E; destruct E as [z [I E]]. apply (prop _ _ _ E).
    rewrite Forall_forall in Z. exact (Z z I).
Qed.
Lemma all_of : forall zs fs, Forall (fun z => ev l z = 0) zs ->
  forallb (plainly_zero known shown zs) (List.map read fs) = true ->
  Forall (fun f => ev l (read f) = 0) fs.
Proof.
  intros zs fs Z E. rewrite forallb_forall in E. rewrite Forall_forall. intros f I.
  apply (plainly zs _ Z), E, in_map, I.
Qed.
Lemma trivial_ring : forall zs, Forall (fun z => ev l z = 0) zs ->
  existsb (fun z => match z with Pc c => number_is_unit known c | _ => false end) zs = true ->
  forall x : R, x = 0.
Proof.
  intros zs Z E x. apply existsb_exists in E; destruct E as [z [I E]].
  destruct z as [c | |]; try discriminate. rewrite Forall_forall in Z. specialize (Z _ I).
  change (num c = 0) in Z. apply (unit_cancel laws _ x (number c E)). rewrite Z. ring.
Qed.

Section Directly.
Variable form : polynomial -> polynomial -> polynomial -> polynomial -> fraction.
Hypothesis sound : forallb (is_sound known form) (items shown) = true.
Lemma is_derived_sound : forall zs f x, Forall (fun z => ev l z = 0) zs -> stands_for l List.nil f x ->
  is_derived known shown zs f = true -> x = 0.
Proof.
  intros zs f x Z S E; unfold is_derived in E. apply orb_true_iff in E; destruct E as [T | E];
    [exact (trivial_ring zs Z T x) |]. apply andb_true_iff in E; destruct E as [V E].
  apply (zero_top List.nil (Forall_nil _) f x S V).
  apply orb_true_iff in E; destruct E as [E | E].
  - exact (plainly zs _ Z E).
  - apply existsb_exists in E; destruct E as [i [I E]]. rewrite forallb_forall in sound.
    specialize (sound i I). destruct i as [zeros g cs d |]; [| discriminate].
    apply andb_true_iff in E; destruct E as [G E].
    assert (M := direct_sound _ _ _ _ _ sound (all_of zs zeros Z G)).
    apply orb_true_iff in E; destruct E as [E | E]; [exact (prop _ _ _ E M) |].
    destruct (read g) as [c | |]; try discriminate.
    apply (unit_cancel laws _ _ (number c E)). change (num c = 0) in M. rewrite M. ring.
Qed.
Lemma cases_sound : forall f css, cases_of known (evaluate known st) (evaluate_quat known st) f = Some css ->
  holds A qs ss f -> Exists (Forall (fun z => ev l z = 0)) css.
Proof.
  induction f; intros css E H; try discriminate; cbn [cases_of] in E.
  - injection E as <-. constructor.
    apply (tops_zero List.nil _ _ (Forall2_cons _ _ (difference_stands List.nil (Forall_nil _) x y) (Forall2_nil _))).
    repeat constructor. apply zero_of_equal, H.
  - injection E as <-. constructor.
    apply (tops_zero List.nil _ _ (differences_stand List.nil (Forall_nil _) p q)).
    destruct (qsub_of_equal _ _ H) as [? [? [? ?]]]. repeat constructor; assumption.
  - destruct (cases_of _ _ _ f1) as [gs |]; [| discriminate].
    destruct (cases_of _ _ _ f2) as [hs |]; [| discriminate]. injection E as <-.
    destruct H as [H1 H2]. specialize (IHf1 _ eq_refl H1). specialize (IHf2 _ eq_refl H2).
    apply Exists_exists in IHf1, IHf2. destruct IHf1 as [u [U Zu]], IHf2 as [v [V Zv]].
    apply Exists_exists. exists (u ++ v). split; [| apply Forall_app; split; assumption].
    apply in_flat_map. exists u; split; [exact U |]. apply in_map, V.
  - destruct (cases_of _ _ _ f1) as [gs |]; [| discriminate].
    destruct (cases_of _ _ _ f2) as [hs |]; [| discriminate]. injection E as <-.
    apply Exists_app. destruct H as [H | H]; [left; apply IHf1 | right; apply IHf2]; trivial.
Qed.
Lemma derived_sound : forall f zs, Forall (fun z => ev l z = 0) zs ->
  derived known shown (evaluate known st) (evaluate_quat known st) zs f = true -> holds A qs ss f.
Proof.
  induction f; intros zs Z E; cbn [derived] in E; try discriminate.
  - apply (minus_zero laws).
    exact (is_derived_sound zs _ _ Z (difference_stands List.nil (Forall_nil _) x y) E).
  - assert (D := differences_stand List.nil (Forall_nil _) p q).
    set (d := qsub (quat_value A qs ss p) (quat_value A qs ss q)) in *.
    assert (F : Forall (fun x => x = 0)
      (List.cons (re d) (List.cons (im d) (List.cons (jm d) (List.cons (km d) List.nil))))).
    { cbv zeta in D. revert D E. generalize (differences known (evaluate_quat known st) List.nil p q).
      intros fs D. induction D as [| f x fs xs S D IH]; intro E; constructor.
      - apply andb_true_iff in E. exact (is_derived_sound zs f x Z S (proj1 E)).
      - apply andb_true_iff in E. exact (IH (proj2 E)). }
    inversion_clear F as [| ? ? F0 G0]. inversion_clear G0 as [| ? ? F1 G1].
    inversion_clear G1 as [| ? ? F2 G2]. inversion_clear G2 as [| ? ? F3 G3].
    apply equal_of_qsub; assumption.
  - apply andb_true_iff in E; destruct E. split; [apply (IHf1 zs) | apply (IHf2 zs)]; trivial.
  - apply orb_true_iff in E; destruct E; [left; apply (IHf1 zs) | right; apply (IHf2 zs)]; trivial.
  - intro H. destruct (cases_of known (evaluate known st) (evaluate_quat known st) f1) as [css |] eqn:C;
      [| discriminate].
    assert (X := cases_sound f1 css C H). apply Exists_exists in X; destruct X as [more [I M]].
    rewrite forallb_forall in E. apply (IHf2 (more ++ zs)); [| exact (E more I)].
    apply Forall_app; split; assumption.
  - destruct (cases_of known (evaluate known st) (evaluate_quat known st) f1) as [gs |] eqn:C1; [| discriminate].
    destruct (cases_of known (evaluate known st) (evaluate_quat known st) f2) as [hs |] eqn:C2; [| discriminate].
    apply andb_true_iff in E; destruct E as [E1 E2]. rewrite forallb_forall in E1, E2. split; intro H.
    + assert (X := cases_sound f1 gs C1 H). apply Exists_exists in X; destruct X as [more [I M]].
      apply (IHf2 (more ++ zs)); [apply Forall_app; split; assumption | exact (E1 more I)].
    + assert (X := cases_sound f2 hs C2 H). apply Exists_exists in X; destruct X as [more [I M]].
      apply (IHf1 (more ++ zs)); [apply Forall_app; split; assumption | exact (E2 more I)].
Qed.
End Directly.

Lemma imply_all : forall B hypotheses f, holds B qs ss (fold_right Imp f hypotheses) ->
  hold_imply B qs ss hypotheses (holds B qs ss f).
Proof. induction hypotheses as [| h hs IH]; intros f H; [exact H | intro E; apply IH, H, E]. Qed.
End At.
End Soundness.

(* What is computed over commutative rings is true there. *)
Lemma none_more : forall R (operations : Operations R) (inverse : Inverse R) st (A : algebra R) qs ss hs,
  found_quaternions st = O -> found_scalars st = O ->
  hold_imply A qs ss hs (holds A qs ss (conclusion st)) ->
  hold_imply A qs ss hs (there_are (found_quaternions st) (fun more => there_are (found_scalars st)
    (fun others => holds A (qs ++ more) (ss ++ others) (conclusion st)))).
Proof.
  intros R operations inverse st A qs ss hs -> ->. cbn [there_are]. rewrite 2!app_nil_r.
  exact (fun H => H).
Qed.
Theorem direct : forall {R} {operations : Operations R} {inverse : Inverse R},
  ring_theory zero one add mul sub opp (@eq R) -> forall known,
  num (modulus known) = zero -> units known = List.nil -> rational known = false ->
  relations known = List.nil -> forall shown st,
  judged_directly known shown st = true -> says st.
Proof.
  intros R operations inverse laws known M U Q L shown st E. unfold judged_directly in E.
  repeat (apply andb_true_iff in E; destruct E as [E ?]).
  apply Nat.eqb_eq in E, H2. apply same_for_all; intros qs Wq. apply same_for_all; intros ss Ws.
  apply none_more; trivial. apply imply_all.
  assert (U' : Forall (fun u => unit (num u)) (units known)) by (rewrite U; constructor).
  assert (Q' : rational known = true -> forall c, c <> 0%Z -> unit (num c)) by (rewrite Q; discriminate).
  assert (D' : divides known = true -> forall x y, mul x y = one -> mul x (inv x) = one).
  { intro D. rewrite D in H1. discriminate. }
  assert (L' : Forall (fun r => ev (coordinates_of qs ss) (read r) = zero) (relations known))
    by (rewrite L; constructor).
  eapply (derived_sound laws known shown M U' Q' D' st qs ss Wq Ws _ eq_refl L' _ H0 _ List.nil); [constructor | exact H].
Qed.
