
(* What the computations say of the values of polynomials in a commutative ring. *)
Section Values.
Context {R : Type} {operations : Operations R} {inverse : Inverse R}.
Hypothesis laws : ring_theory zero one add mul sub opp (@eq R).
Add Ring values_ring : laws.
Let morphism := gen_phiZ_morph (Eqsth R) (Eq_ext add mul opp) laws.
Let almost := Rth_ARth (Eqsth R) (Eq_ext add mul opp) laws.
Definition ev (l : list R) (f : polynomial) : R :=
  Pphi zero add mul (gen_phiZ zero one add mul opp) l f.

Lemma ev_add : forall l f g, ev l (padd f g) = ev l f + ev l g.
Proof. intros. exact (Padd_ok (Eqsth R) (Eq_ext _ _ _) almost morphism _ _ _). Qed.
Lemma ev_sub : forall l f g, ev l (psub f g) = ev l f - ev l g.
Proof. intros. exact (Psub_ok (Eqsth R) (Eq_ext _ _ _) almost morphism _ _ _). Qed.
Lemma ev_mul : forall l f g, ev l (pmul f g) = ev l f * ev l g.
Proof. intros. exact (Pmul_ok (Eqsth R) (Eq_ext _ _ _) almost morphism _ _ _). Qed.
Lemma ev_opp : forall l f, ev l (popp f) = - ev l f.
Proof. intros. exact (Popp_ok (Eqsth R) (Eq_ext _ _ _) almost morphism _ _). Qed.
Lemma ev_shift : forall l n f, ev l (mkPinj n f) = ev (BinList.jump n l) f.
Proof. intros. exact (mkPinj_ok zero add mul (Eqsth R) _ _ _ _). Qed.
Lemma ev_number : forall l c, ev l (Pc c) = num c.
Proof. reflexivity. Qed.
Lemma ev_variable : forall l n, ev l (variable n) = BinList.nth zero n l.
Proof. intros. symmetry. exact (mkX_ok (Eqsth R) (Eq_ext _ _ _) almost morphism _ _). Qed.
Lemma ev_join : forall l f n g, ev l (mkPX 0%Z Zeq_bool f n g) =
  ev l f * pow_pos mul (List.hd zero l) n + ev (List.tl l) g.
Proof. intros. exact (mkPX_ok (Eqsth R) (Eq_ext _ _ _) almost morphism _ _ _ _). Qed.
Lemma num_zero : num 0 = 0. Proof. reflexivity. Qed.
Lemma num_one : num 1 = 1. Proof. reflexivity. Qed.
Lemma num_add : forall m n, num (m + n) = num m + num n.
Proof. exact (morph_add morphism). Qed.
Lemma num_mul : forall m n, num (m * n) = num m * num n.
Proof. exact (morph_mul morphism). Qed.
Lemma unit_mul : forall x y, unit x -> unit y -> unit (x * y).
Proof. intros x y [u E] [v F]; exists (u * v). transitivity ((x * u) * (y * v)); [ring |]. rewrite E, F. ring. Qed.
Lemma unit_one : unit 1.
Proof. exists 1; ring. Qed.
Lemma unit_cancel : forall x y, unit x -> x * y = 0 -> y = 0.
Proof. intros x y [u E] F. transitivity ((x * u) * y); [rewrite E; ring |]. transitivity (u * (x * y)); [ring |]. rewrite F; ring. Qed.
Lemma unit_factor : forall x y, unit (x * y) -> unit x.
Proof. intros x y [u E]; exists (y * u). transitivity (x * y * u); [ring | exact E]. Qed.
Lemma minus_zero : forall x y, x - y = 0 -> x = y.
Proof. intros x y E. transitivity (x - y + y); [ring | rewrite E; ring]. Qed.

Variable known : knowledge.
Hypothesis modulus_is_zero : num (modulus known) = 0.
Hypothesis units_are : Forall (fun u => unit (num u)) (units known).
Hypothesis rationals : rational known = true -> forall c, c <> 0%Z -> unit (num c).

Lemma num_residue : forall c, num (residue known c) = num c.
Proof.
  intro c; unfold residue. destruct (Z.eqb_spec (modulus known) 0) as [|N]; [reflexivity |].
  rewrite (Z.div_mod c (modulus known) N) at 2. rewrite num_add, num_mul, modulus_is_zero. ring.
Qed.
Lemma ev_reduced : forall f l, ev l (reduced known f) = ev l f.
Proof.
  induction f as [c | n f IH | f IH n g JH]; intro l; cbn [reduced].
  - apply num_residue.
  - rewrite ev_shift. apply IH.
  - rewrite ev_join, IH, JH. reflexivity.
Qed.
Lemma ev_modulo : forall l f, ev l (modulo known f) = ev l f.
Proof. intros; unfold modulo. destruct (Z.eqb _ _); [reflexivity | apply ev_reduced]. Qed.
Lemma ev_is_zero : forall f, is_zero known f = true -> forall l, ev l f = 0.
Proof.
  induction f as [c | n f IH | f IH n g JH]; cbn [is_zero]; intros E l.
  - apply Z.eqb_eq in E. rewrite ev_number, <- num_residue, E. reflexivity.
  - exact (IH E (BinList.jump n l)).
  - apply andb_true_iff in E; destruct E as [E F].
    change (ev l f * pow_pos mul (List.hd zero l) n + ev (List.tl l) g = 0).
    rewrite (IH E), (JH F). ring.
Qed.
Lemma unit_divided : forall fuel c, unit (num (divided known fuel c)) -> unit (num c).
Proof.
  induction fuel as [| fuel IH]; intros c U; [exact U |]. cbn [divided] in U.
  destruct (List.find _ (units known)) as [u |] eqn:E; [| exact U].
  apply find_some in E; destruct E as [I E]. apply Z.eqb_eq in E. rewrite E, num_mul.
  apply unit_mul; [| exact (IH _ U)]. rewrite Forall_forall in units_are. exact (units_are u I).
Qed.
Lemma number_unit : forall c, number_is_unit known c = true -> unit (num c).
Proof.
  intros c E; unfold number_is_unit in E. destruct (rational known) eqn:Q.
  - apply rationals; [reflexivity |]. intros ->. discriminate.
  - apply Z.eqb_eq in E. apply (unit_divided (S (Z.to_nat (Z.log2 (Z.abs c))))).
    destruct (rel_prime_bezout _ _ (proj1 (Zgcd_1_rel_prime _ _) E)) as [u v F].
    exists (num u). transitivity (num v * num (modulus known) + num (u * divided known (S (Z.to_nat (Z.log2 (Z.abs c)))) c)).
    + rewrite num_mul, modulus_is_zero. ring.
    + rewrite <- num_mul, <- num_add, Z.add_comm, F. reflexivity.
Qed.
Lemma ev_times : forall l c f, ev l (times c f) = num c * ev l f.
Proof. intros; unfold times. rewrite ev_mul. reflexivity. Qed.
Lemma proportional_zero : forall f g l, proportional known f g = true -> ev l f = 0 -> ev l g = 0.
Proof.
  intros f g l E Z; unfold proportional in E. rewrite <- ev_modulo in Z. rewrite <- ev_modulo.
  apply orb_true_iff in E; destruct E as [E | E].
  - apply orb_true_iff in E; destruct E as [E | E]; apply ev_is_zero with (l := l) in E.
    + rewrite ev_sub in E. apply minus_zero in E. rewrite <- E. exact Z.
    + rewrite ev_add, Z in E. rewrite <- E. ring.
  - apply andb_true_iff in E; destruct E as [E F]. apply andb_true_iff in E; destruct E as [U V].
    apply (unit_cancel _ _ (number_unit _ V)). apply ev_is_zero with (l := l) in F.
    rewrite ev_sub, 2!ev_times in F. apply minus_zero in F. rewrite <- F, Z. ring.
Qed.
Lemma proportional_unit : forall f g l, proportional known f g = true -> ev l g = 0 -> ev l f = 0.
Proof.
  intros f g l E Z; unfold proportional in E. rewrite <- ev_modulo in Z. rewrite <- ev_modulo.
  apply orb_true_iff in E; destruct E as [E | E].
  - apply orb_true_iff in E; destruct E as [E | E]; apply ev_is_zero with (l := l) in E.
    + rewrite ev_sub in E. apply minus_zero in E. rewrite E. exact Z.
    + rewrite ev_add, Z in E. rewrite <- E. ring.
  - apply andb_true_iff in E; destruct E as [E F]. apply andb_true_iff in E; destruct E as [U V].
    apply (unit_cancel _ _ (number_unit _ U)). apply ev_is_zero with (l := l) in F.
    rewrite ev_sub, 2!ev_times in F. apply minus_zero in F. rewrite F, Z. ring.
Qed.
Lemma sum_of_zeros : forall l fs cs, Forall (fun f => ev l f = 0) fs -> ev l (sum_of cs fs) = 0.
Proof.
  intros l fs cs F; revert cs; induction F as [| f fs E F IH]; intros [| c cs]; try reflexivity.
  cbn [sum_of]. rewrite ev_add, ev_mul, IH, E. ring.
Qed.
Lemma multiple_zero : forall l s d f, is_multiple known s d f = true -> ev l s = 0 -> ev l f = 0.
Proof.
  intros l s d f E Z; unfold is_multiple in E. apply andb_true_iff in E; destruct E as [U E].
  apply (unit_cancel _ _ (number_unit _ U)). apply ev_is_zero with (l := l) in E.
  rewrite ev_sub, ev_times in E. apply minus_zero in E. rewrite <- E. exact Z.
Qed.

(* Fractions. *)
Section Fractions.
Variables (l : list R) (factors : list polynomial).
Hypothesis units_divide : Forall (fun f => unit (ev l f)) factors.
Hypothesis inverses_are : divides known = true -> forall x y, x * y = 1 -> x * inv x = 1.
Definition stands_for (f : fraction) (x : R) : Prop :=
  valid f = true -> x * ev l (product factors (below f)) = ev l (top f).
Lemma ev_power_add : forall f m n, ev l (power f (m + n)) = ev l (power f m) * ev l (power f n).
Proof.
  intros f m n; induction m as [| m IH]; cbn [power Nat.add]; [cbn; change (gen_phiZ 0 1 add mul opp 1) with (1:R); ring |].
  rewrite 2!ev_mul, IH. ring.
Qed.
Lemma ev_one : ev l (Pc 1%Z) = 1. Proof. reflexivity. Qed.
Lemma product_nil : forall fs, ev l (product fs List.nil) = 1.
Proof. intros []; reflexivity. Qed.
Lemma product_units : forall ns, unit (ev l (product factors ns)).
Proof.
  induction units_divide as [| f fs U F IH]; intros [| n ns]; try apply unit_one.
  cbn [product]. rewrite ev_mul. apply unit_mul; [| apply IH, F].
  induction n as [| n JH]; cbn [power]; [apply unit_one | rewrite ev_mul; apply unit_mul; assumption].
Qed.
Lemma product_sum : forall fs ms ns, ev l (product fs (joined Nat.add ms ns)) =
  ev l (product fs ms) * ev l (product fs ns).
Proof.
  induction fs as [| f fs IH]; intros ms ns.
  - destruct (joined _ _ _), ms, ns; cbn [product]; rewrite ev_one; ring.
  - destruct ms as [| m ms], ns as [| n ns]; cbn [joined List.map product].
    + rewrite ev_one; ring.
    + assert (E : List.map (Nat.add 0) ns = ns) by (induction ns; cbn in *; congruence).
      rewrite E, ev_one. cbn. ring.
    + assert (E : List.map (fun m => Nat.add m 0) ms = ms).
      { clear; induction ms as [| k ms IH]; cbn; [reflexivity |]. rewrite IH, Nat.add_0_r. reflexivity. }
      rewrite E, Nat.add_0_r, ev_one. ring.
    + rewrite 3!ev_mul, ev_power_add, IH. ring.
Qed.
Lemma product_max : forall fs ms ns, ev l (product fs ms) *
  ev l (product fs (joined Nat.sub (joined Nat.max ms ns) ms)) = ev l (product fs (joined Nat.max ms ns)) /\
  ev l (product fs ns) *
  ev l (product fs (joined Nat.sub (joined Nat.max ms ns) ns)) = ev l (product fs (joined Nat.max ms ns)).
Proof.
  assert (D : forall ns, List.map (fun m => Nat.sub m 0) ns = ns).
  { induction ns as [| k ns IH]; cbn [List.map]; [reflexivity |]. rewrite IH, Nat.sub_0_r. reflexivity. }
  assert (M : forall ns, List.map (Nat.max 0) ns = ns).
  { induction ns as [| k ns IH]; cbn [List.map]; [reflexivity |]. rewrite IH. reflexivity. }
  assert (N : forall ns, List.map (fun m => Nat.max m 0) ns = ns).
  { induction ns as [| k ns IH]; cbn [List.map]; [reflexivity |]. rewrite IH, Nat.max_0_r. reflexivity. }
  assert (S : forall fs ns, ev l (product fs ns) * ev l (product fs (joined Nat.sub ns ns)) = ev l (product fs ns)).
  { induction fs as [| f fs IH]; intros [| n ns]; cbn [joined List.map product]; rewrite ?ev_one; try ring.
    rewrite 2!ev_mul, Nat.sub_diag. cbn [power]. rewrite ev_one.
    transitivity (ev l (power f n) * (ev l (product fs ns) * ev l (product fs (joined Nat.sub ns ns)))); [ring |].
    rewrite IH. reflexivity. }
  assert (Z : forall fs ns, ev l (product fs (joined Nat.sub ns List.nil)) = ev l (product fs ns)).
  { intros fs [| n ns]; cbn [joined List.map]; [reflexivity |]. rewrite D, Nat.sub_0_r. reflexivity. }
  induction fs as [| f fs IH]; intros ms ns.
  - cbn [product]. rewrite ev_one. split; ring.
  - destruct ms as [| m ms], ns as [| n ns].
    + cbn. change (gen_phiZ 0 1 add mul opp 1) with (1:R). split; ring.
    + replace (joined Nat.max List.nil (List.cons n ns)) with (List.cons n ns) by (symmetry; apply M).
      split; [rewrite Z; cbn [product]; rewrite ev_one; ring | apply S].
    + replace (joined Nat.max (List.cons m ms) List.nil) with (List.cons m ms)
        by (symmetry; cbn [joined]; apply N).
      split; [apply S | rewrite Z; cbn [product]; rewrite ev_one; ring].
    + cbn [joined product]. rewrite 5!ev_mul. destruct (IH ms ns) as [E F].
      assert (G : forall a b, ev l (power f a) * ev l (power f (Nat.max a b - a)) = ev l (power f (Nat.max a b))).
      { intros a b. rewrite <- ev_power_add. f_equal. f_equal. lia. }
      split.
      * rewrite <- E, <- (G m n). ring.
      * rewrite <- F, (Nat.max_comm m n), <- (G n m). ring.
Qed.
Lemma made_stands : forall v f ns x, (v = true -> x * ev l (product factors ns) = ev l f) ->
  stands_for (made known v f ns) x.
Proof.
  intros v f ns x E V. cbn in V. unfold made. cbn [top below].
  destruct (is_zero known (modulo known f)) eqn:Z; [| rewrite ev_modulo; exact (E V)].
  specialize (E V). rewrite <- (ev_modulo l f), (ev_is_zero _ Z) in E.
  rewrite (ev_is_zero _ Z), product_nil.
  rewrite (unit_cancel (ev l (product factors ns)) x (product_units ns)); [ring |].
  rewrite <- E; ring.
Qed.
Lemma valid_both : forall a b, a && b = true -> a = true /\ b = true.
Proof. intros a b; apply andb_true_iff. Qed.
Lemma stands_polynomial : forall f, stands_for (polynomial_fraction f) (ev l f).
Proof. intros f _; unfold polynomial_fraction; cbn [top below]. rewrite product_nil. ring. Qed.
Lemma stands_add : forall f x g y, stands_for f x -> stands_for g y ->
  stands_for (add (Operations := fractions known factors) f g) (x + y).
Proof.
  intros f x g y F G; apply made_stands; intro V; apply valid_both in V; destruct V as [V W].
  rewrite ev_add, 2!ev_mul, <- (F V), <- (G W).
  destruct (product_max factors (below f) (below g)) as [M N].
  set (c := ev l (product factors (joined Nat.max (below f) (below g)))) in *.
  transitivity (x * c + y * c); [ring |]. rewrite <- M at 1. rewrite <- N. ring.
Qed.
Lemma stands_sub : forall f x g y, stands_for f x -> stands_for g y ->
  stands_for (sub (Operations := fractions known factors) f g) (x - y).
Proof.
  intros f x g y F G; apply made_stands; intro V; apply valid_both in V; destruct V as [V W].
  rewrite ev_sub, 2!ev_mul, <- (F V), <- (G W).
  destruct (product_max factors (below f) (below g)) as [M N].
  set (c := ev l (product factors (joined Nat.max (below f) (below g)))) in *.
  transitivity (x * c - y * c); [ring |]. rewrite <- M at 1. rewrite <- N. ring.
Qed.
Lemma stands_mul : forall f x g y, stands_for f x -> stands_for g y ->
  stands_for (mul (Operations := fractions known factors) f g) (x * y).
Proof.
  intros f x g y F G; apply made_stands; intro V; apply valid_both in V; destruct V as [V W].
  rewrite ev_mul, product_sum, <- (F V), <- (G W). ring.
Qed.
Lemma stands_opp : forall f x, stands_for f x ->
  stands_for (opp (Operations := fractions known factors) f) (- x).
Proof.
  intros f x F V. cbn [opp fractions top below] in *. rewrite ev_opp, <- (F V). ring.
Qed.
Lemma ev_position : forall f fs ns, position known f fs = Some ns -> ev l (product fs ns) = ev l f.
Proof.
  induction fs as [| g fs IH]; intros ns E; [discriminate |]. cbn [position] in E.
  destruct (is_zero known (psub f g)) eqn:Z.
  - injection E as <-. cbn [product power]. rewrite 2!ev_mul, product_nil, ev_one.
    apply ev_is_zero with (l := l) in Z. rewrite ev_sub in Z. apply minus_zero in Z. rewrite Z; ring.
  - destruct (position known f fs) as [ms |]; [| discriminate]. injection E as <-.
    cbn [product power]. rewrite ev_mul, ev_one, (IH ms eq_refl). ring.
Qed.
Lemma stands_inv : forall f x, stands_for f x -> stands_for (reciprocal known factors f) (inv x).
Proof.
  intros f x F. unfold reciprocal.
  assert (I : forall d, divides known = true -> valid f = true -> ev l d = ev l (top f) -> unit (ev l d) ->
    inv x * ev l d = ev l (product factors (below f))).
  { intros d D V E [u U]. specialize (F V).
    assert (X : x * inv x = 1).
    { apply (inverses_are D x (ev l (product factors (below f)) * u)).
      transitivity (x * ev l (product factors (below f)) * u); [ring |]. rewrite F, <- E. exact U. }
    rewrite E, <- F. transitivity (x * inv x * ev l (product factors (below f))); [ring |].
    rewrite X. ring. }
  destruct (is_zero known (psub (top f) (Pc 1%Z))) eqn:Z.
  - intro V; apply valid_both in V; destruct V as [V D]. cbn [top below].
    apply ev_is_zero with (l := l) in Z. rewrite ev_sub, ev_one in Z. apply minus_zero in Z.
    rewrite product_nil, <- ev_one. apply I; trivial; rewrite ev_one; [symmetry; exact Z | apply unit_one].
  - destruct (position known (top f) factors) as [ns |] eqn:P; [| intro V; discriminate V].
    intro V; apply valid_both in V; destruct V as [V D]. cbn [top below].
    rewrite (ev_position _ _ _ P). apply I; trivial.
    rewrite <- (ev_position _ _ _ P). apply product_units.
Qed.
End Fractions.

(* The symbols of the unknowns have the unknowns as values. *)
Definition coordinates_of (qs : list (quaternion R)) (ss : list R) : list R :=
  flat_map (fun q => List.cons (re q) (List.cons (im q) (List.cons (jm q) (List.cons (km q) List.nil)))) qs ++ ss.
Definition qev (l : list R) (q : quaternion polynomial) (x : quaternion R) : Prop :=
  ev l (re q) = re x /\ ev l (im q) = im x /\ ev l (jm q) = jm x /\ ev l (km q) = km x.
Lemma scalar_symbols_are : forall ss,
  Forall2 (fun f x => ev ss f = x) (scalar_symbols (length ss)) ss.
Proof.
  induction ss as [| s ss IH]; cbn [scalar_symbols length]; constructor.
  - rewrite ev_variable. reflexivity.
  - assert (G : forall fs xs, Forall2 (fun f x => ev ss f = x) fs xs ->
      Forall2 (fun f x => ev (List.cons s ss) f = x) (List.map (mkPinj 1) fs) xs).
    { intros fs xs F; induction F as [| f x fs xs E F JH]; constructor; [| exact JH].
      rewrite ev_shift. exact E. }
    exact (G _ _ IH).
Qed.
Lemma quaternion_symbols_are : forall qs ss,
  Forall2 (qev (coordinates_of qs ss)) (quaternion_symbols (length qs)) qs.
Proof.
  induction qs as [| q qs IH]; intro ss; cbn [quaternion_symbols length]; constructor.
  - unfold qev; cbn [re im jm km]. rewrite 4!ev_variable. repeat split.
  - specialize (IH ss). revert IH. generalize (quaternion_symbols (length qs)).
    unfold coordinates_of. cbn [flat_map app]. generalize (flat_map (fun q => re q :: im q :: jm q :: km q :: nil)%list qs ++ ss).
    intros l fs F; induction F as [| f x fs xs E F JH]; constructor; [| exact JH].
    unfold qev in *; cbn [re im jm km]. rewrite 4!ev_shift. exact E.
Qed.
Lemma ev_after : forall qs ss f, ev (coordinates_of qs ss) (after (4 * length qs) f) = ev ss f.
Proof.
  induction qs as [| q qs IH]; intros ss f; [reflexivity |].
  replace (4 * length (q :: qs)%list)%nat with (S (S (S (S (4 * length qs))))) by (cbn; lia).
  cbn [after]. rewrite 4!ev_shift. exact (IH ss f).
Qed.
End Values.
