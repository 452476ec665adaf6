
(* ---------------------------------------------------------------------------------------------- *)
(* What each theorem rests on: the computations above, over every commutative ring, every field,   *)
(* one field or ring.                                                                              *)
(* ---------------------------------------------------------------------------------------------- *)

Definition field (R : Type) {operations : Operations R} {inverse : Inverse R} : Prop :=
  field_theory zero one add mul sub opp (fun x y => mul x (inv y)) inv (@eq R) /\
  forall x y : R, x = y \/ x <> y.
Notation "'every' 'commutative' 'ring' R , P" :=
  (forall (R : Type) (operations : Operations R), ring_theory zero one add mul sub opp (@eq R) -> P)
  (at level 200, R name).
Notation "'every' 'field' R , P" :=
  (forall (R : Type) (operations : Operations R) (inverse : Inverse R), field R -> P)
  (at level 200, R name).

Definition over_rings : knowledge := Knowledge 0 List.nil false false false false List.nil.
Definition over_fields (primes : list Z) : knowledge := Knowledge 0 primes false true false false List.nil.
Definition characteristic (p : Z) : knowledge := Knowledge p List.nil false true false false List.nil.

Theorem commutative_rings : forall shown st, judged_directly over_rings shown st = true ->
  every commutative ring R, says (R := R) (inverse := fun x => x) st.
Proof. intros shown st E R operations laws. exact (direct laws over_rings eq_refl eq_refl eq_refl eq_refl shown st E). Qed.

Lemma field_units : forall R (operations : Operations R) (inverse : Inverse R), field R ->
  forall x : R, x <> zero -> unit x.
Proof.
  intros R operations inverse [F _] x N. exists (inv x).
  rewrite (Rmul_comm (F_R F)). exact (Finv_l F x N).
Qed.
Lemma field_inverses : forall R (operations : Operations R) (inverse : Inverse R), field R ->
  forall x y : R, mul x y = one -> mul x (inv x) = one.
Proof.
  intros R operations inverse [F D] x y E. rewrite (Rmul_comm (F_R F)). apply (Finv_l F).
  intros ->. apply (F_1_neq_0 F). rewrite <- E.
  exact (ARmul_0_l (Rth_ARth (Eqsth R) (Eq_ext add mul opp) (F_R F)) y).
Qed.
Theorem characteristic_fields : forall p shown st, judged (characteristic p) shown st = true ->
  every field R, num (R := R) p = zero -> says st.
Proof.
  intros p shown st E R operations inverse [F D] M.
  apply (judged_says inv F D (characteristic p) shown st M (Forall_nil _)); try discriminate.
  - intros _. exact (field_inverses R operations inverse (Logic.conj F D)).
  - intros l. constructor.
  - exact E.
Qed.
Theorem fields : forall general special st, judged (over_fields (List.map fst special)) general st = true ->
  forallb (fun s => judged (characteristic (fst s)) (snd s) st) special = true ->
  every field R, says (R := R) st.
Proof.
  intros general special st G S R operations inverse F.
  assert (C : Exists (fun s => num (R := R) (fst s) = zero) special \/
    Forall (fun s => unit (num (R := R) (fst s))) special).
  { clear G S. induction special as [| s special [E | E]]; [right; constructor | left; right; exact E |].
    destruct (proj2 F (num (fst s)) zero) as [Z | N]; [left; left; exact Z | right].
    constructor; [apply (field_units _ _ _ F), N | exact E]. }
  destruct C as [C | C].
  - apply Exists_exists in C; destruct C as [[p shown] [I Z]]. rewrite forallb_forall in S.
    exact (characteristic_fields p shown st (S _ I) R operations inverse F Z).
  - destruct F as [F D].
    apply (judged_says inv F D (over_fields (List.map fst special)) general st eq_refl); try discriminate.
    + apply Forall_map, C.
    + intros _. exact (field_inverses R operations inverse (Logic.conj F D)).
    + intros l; constructor.
    + exact G.
Qed.

(* GF(p), in which x^p = x; and the residues modulo n. *)
Definition power_relation (p : Z) (n : positive) : text :=
  PEsub (PEpow (PEX Z n) (Z.to_N p)) (PEX Z n).
Definition in_GF (p : Z) (variables : nat) : knowledge :=
  Knowledge p List.nil false true false false
    (List.map (fun k => power_relation p (Pos.of_succ_nat k)) (List.seq 0 variables)).
Definition fermat (p : Z) : bool :=
  forallb (fun x => residue_eqb p (pow_N one mul x (Z.to_N p)) x) (all_residues p).
Lemma GF_field : forall p, is_prime p = true -> field (GF p).
Proof.
  intros p P. split; [| apply residue_equal_or_not]. apply residue_field_laws; [| exact P].
  unfold is_prime in P. apply andb_true_iff in P; destruct P as [L _].
  apply Z.ltb_lt in L. apply Z.ltb_lt. lia.
Qed.
Theorem prime_field : forall p variables shown st, is_prime p = true -> fermat p = true ->
  judged (in_GF p variables) shown st = true -> says (R := GF p) st.
Proof.
  intros p variables shown st P M E. assert (F := GF_field p P).
  apply (judged_says inv (proj1 F) (proj2 F) (in_GF p variables) shown st (modulus_vanishes p) (Forall_nil _));
    try discriminate; [intros _; exact (field_inverses _ _ _ F) | | exact E].
  intro l. apply Forall_map, Forall_forall. intros k _. assert (L := F_R (proj1 F)).
  unfold power_relation.
  assert (S := norm_aux_spec (Eqsth (GF p)) (Eq_ext add mul opp) (Rth_ARth (Eqsth _) (Eq_ext _ _ _) L)
    (gen_phiZ_morph (Eqsth _) (Eq_ext _ _ _) L) (pow_N_th one mul (Eqsth _)) l
    (power_relation p (Pos.of_succ_nat k))).
  unfold ev, read. refine (eq_trans (eq_sym S) _). cbn [PEeval power_relation id_phi_N].
  unfold id_phi_N. set (x := BinList.nth zero (Pos.of_succ_nat k) l).
  unfold fermat in M. rewrite forallb_forall in M.
  assert (I : In x (all_residues p)).
  { apply all_residues_are. unfold is_prime in P. apply andb_true_iff in P; destruct P as [P _].
    apply Z.ltb_lt in P. apply Z.ltb_lt. lia. }
  specialize (M x I). apply residue_eqb_is in M. rewrite M.
  rewrite (Rsub_def L), (Ropp_def L). reflexivity.
Qed.
Definition residues_known (n : Z) : knowledge := Knowledge n List.nil false false false false List.nil.
Theorem residue_ring : forall n shown st, judged_directly (residues_known n) shown st = true ->
  says (R := GF n) st.
Proof.
  intros n shown st E.
  exact (direct (residue_laws n) (residues_known n) (modulus_vanishes n) eq_refl eq_refl eq_refl shown st E).
Qed.
Theorem residues_all_cases : forall n st, Z.ltb 0 n = true ->
  exhausted (residue_eqb n) (all_residues n) st = true -> says (R := GF n) st.
Proof.
  intros n st P. exact (all_cases _ (residue_eqb_is n) (residue_inverse_is n P) _ (all_residues_are n P) st).
Qed.
Theorem residues_fail : forall n st qs ss, Z.ltb 0 n = true ->
  fails (residue_eqb n) st qs ss = true -> ~ says (R := GF n) st.
Proof. intros n st qs ss P. exact (counterexample _ (residue_eqb_is n) (residue_inverse_is n P) st qs ss). Qed.
Theorem residues_example : forall n st qs ss, Z.ltb 0 n = true ->
  succeeds (residue_eqb n) st qs ss = true -> says (R := GF n) st.
Proof. intros n st qs ss P. exact (example _ (residue_eqb_is n) (residue_inverse_is n P) st qs ss). Qed.

(* The rationals. *)
Global Instance rational_operations : Operations Qc := {|
  zero := Q2Qc 0%Q; one := 1%Qc; add := Qcplus; mul := Qcmult; sub := Qcminus; opp := Qcopp |}.
Global Instance rational_inverse : Inverse Qc := Qcinv.
Definition rational_eqb (x y : Qc) : bool :=
  Z.eqb (Qnum (this x)) (Qnum (this y)) && Pos.eqb (Qden (this x)) (Qden (this y)).
Lemma rational_eqb_is : forall x y, rational_eqb x y = true <-> x = y.
Proof.
  intros x y; unfold rational_eqb; rewrite andb_true_iff, Z.eqb_eq, Pos.eqb_eq. split.
  - intros [E F]. apply Qc_is_canon. unfold Qeq. rewrite E, F. reflexivity.
  - intros ->. split; reflexivity.
Qed.
Lemma rational_field : field Qc.
Proof.
  split; [exact Qcft |]. intros x y. destruct (Qc_eq_dec x y); [left | right]; assumption.
Qed.
Lemma num_rational : forall z, num z = Q2Qc (inject_Z z).
Proof.
  assert (M := gen_phiZ_morph (Eqsth Qc) (Eq_ext add mul opp) Qcrt).
  assert (A : forall a b, Qcplus (Q2Qc (inject_Z a)) (Q2Qc (inject_Z b)) = Q2Qc (inject_Z (a + b))).
  { intros a b. apply Qc_is_canon. cbn [this Qcplus Q2Qc]. rewrite !Qred_correct, inject_Z_plus. reflexivity. }
  assert (H : forall p, num (Z.pos p) = Q2Qc (inject_Z (Z.pos p))).
  { intro p. induction p using Pos.peano_ind; [reflexivity |].
    rewrite Pos2Z.inj_succ, <- Z.add_1_r. etransitivity; [exact (morph_add M (Z.pos p) 1) |].
    change (Qcplus (num (Z.pos p)) (Q2Qc (inject_Z 1)) = Q2Qc (inject_Z (Z.pos p + 1))). rewrite IHp. apply A. }
  intros [| p | p]; [reflexivity | apply H |].
  change (Qcopp (num (Z.pos p)) = Q2Qc (inject_Z (- Z.pos p))). rewrite H.
  apply Qc_is_canon. cbn [this Qcopp Q2Qc]. rewrite !Qred_correct. reflexivity.
Qed.
Lemma num_injective : forall z, num z = (zero : Qc) -> z = 0%Z.
Proof.
  intros z E. rewrite num_rational in E. apply (f_equal this) in E.
  assert (F : inject_Z z == inject_Z 0).
  { rewrite <- (Qred_correct (inject_Z z)). change (Qred (inject_Z z)) with (this (Q2Qc (inject_Z z))).
    rewrite E. reflexivity. }
  unfold Qeq, inject_Z in F. cbn in F. rewrite Z.mul_1_r in F. exact F.
Qed.
Lemma rational_numbers : forall c, c <> 0%Z -> unit (num (R := Qc) c).
Proof.
  intros c N. apply (field_units _ _ _ rational_field). intro E. apply N, num_injective, E.
Qed.
(* A sum of squares with positive coefficients is 0 only if all the terms are. *)
Lemma square_positive : forall x : Qc, (0 <= x * x)%Qc.
Proof.
  intro x. unfold Qcle. cbn [this Qcmult Q2Qc]. rewrite !Qred_correct.
  destruct (this x) as [a b]. unfold Qle, Qmult; cbn. nia.
Qed.
Lemma square_zero : forall x : Qc, (x * x = 0 -> x = 0)%Qc.
Proof. intros x E. destruct (Qcmult_integral x x E); assumption. Qed.
Lemma weighted_squares : forall terms : list (Qc * Qc), Forall (fun t => (0 < fst t)%Qc) terms ->
  (0 <= fold_right (fun t s => fst t * (snd t * snd t) + s) 0 terms)%Qc /\
  (fold_right (fun t s => fst t * (snd t * snd t) + s)%Qc (Q2Qc 0%Q) terms = 0%Qc ->
  Forall (fun t => snd t = Q2Qc 0%Q) terms).
Proof.
  intros terms P; induction P as [| [c x] terms C P [IH JH]]; [split; [apply Qcle_refl | constructor] |].
  cbn [fold_right fst snd] in *.
  assert (S : (0 <= c * (x * x))%Qc).
  { replace (Q2Qc 0%Q) with (0 * (x * x))%Qc by ring.
    apply Qcmult_le_compat_r; [apply Qclt_le_weak, C | apply square_positive]. }
  set (s := fold_right _ _ terms) in *. split.
  - replace (Q2Qc 0%Q) with (0 + 0)%Qc by ring. apply Qcplus_le_compat; assumption.
  - intro E.
    assert (T : (c * (x * x) = 0)%Qc).
    { apply Qcle_antisym; [| exact S]. replace (Q2Qc 0%Q) with (c * (x * x) + s)%Qc.
      replace (c * (x * x))%Qc with (c * (x * x) + 0)%Qc at 1 by ring.
      apply Qcplus_le_compat; [apply Qcle_refl | exact IH]. }
    assert (U : (s = 0)%Qc) by (rewrite T in E; rewrite <- E; ring).
    constructor; [| exact (JH U)]. cbn. apply square_zero.
    destruct (Qcmult_integral _ _ T) as [Z | Z]; [| exact Z].
    rewrite Z in C. elim (Qclt_not_eq _ _ C). reflexivity.
Qed.
Lemma rational_squares : forall terms : list (Z * Qc), Forall (fun t => (0 < fst t)%Z) terms ->
  fold_right (fun t s => add (mul (num (fst t)) (mul (snd t) (snd t))) s) zero terms = zero ->
  Forall (fun t => snd t = zero) terms.
Proof.
  intros terms P E.
  assert (W := proj2 (weighted_squares (List.map (fun t => (num (fst t), snd t)) terms)
    ltac:(apply Forall_map; revert P; apply Forall_impl; intros [c x] C; cbn [fst] in *;
      rewrite num_rational; unfold Qclt; cbn [this Q2Qc]; rewrite !Qred_correct; 
      unfold Qlt, inject_Z; cbn; lia))).
  apply (Forall_map (fun t => (num (fst t), snd t)) (fun t : Qc * Qc => snd t = zero)). apply W.
  refine (eq_trans _ E). clear. induction terms as [| t terms IH]; [reflexivity |].
  cbn [List.map fold_right fst snd]. rewrite IH. reflexivity.
Qed.
(* The norm form is definite if t*t + 4*a and b are negative. *)
Definition definite (A : algebra Qc) : bool :=
  let negative x := Z.ltb (Qnum (this x)) 0 in
  negative (const_t A * const_t A + num 4 * const_a A) && negative (const_b A).
Lemma is_negative : forall x : Qc, Z.ltb (Qnum (this x)) 0 = true -> (0 < - x)%Qc.
Proof.
  intros x E. apply Z.ltb_lt in E. unfold Qclt. cbn [this Qcopp Q2Qc]. rewrite !Qred_correct.
  destruct (this x) as [a b]; cbn in *. unfold Qlt; cbn. lia.
Qed.
Lemma definite_norm : forall A, definite A = true -> forall q, norm A q = zero -> q = embed zero.
Proof.
  intros [a t b] D [w x y z] E. unfold definite in D. cbn [const_a const_t const_b] in D.
  apply andb_true_iff in D; destruct D as [D B]. apply is_negative in D, B.
  change (num 4 : Qc) with ((1+1)*(1+1))%Qc in D.
  set (d := (- (t * t + (1 + 1) * (1 + 1) * a))%Qc) in *.
  change (0 < d)%Qc in D. change (0 < - b)%Qc in B.
  assert (DB : (0 < d * - b)%Qc).
  { replace (Q2Qc 0%Q) with (0 * - b)%Qc by ring. apply Qcmult_lt_compat_r; assumption. }
  assert (W := proj2 (weighted_squares
    (List.cons (1%Qc, ((1+1) * w + t * x)%Qc) (List.cons (d, x)
      (List.cons ((- b)%Qc, ((1+1) * y + t * z)%Qc) (List.cons ((d * - b)%Qc, z) List.nil))))
    ltac:(repeat constructor; assumption))).
  cbn [fold_right fst snd] in W.
  assert (X : (w * w + t * (w * x) - a * (x * x) - b * (y * y + t * (y * z) - a * (z * z)) = 0)%Qc) by exact E.
  assert (Y := W ltac:(transitivity ((1+1)*(1+1) * (w * w + t * (w * x) - a * (x * x) - b * (y * y + t * (y * z) - a * (z * z))))%Qc;
    [unfold d; ring | rewrite X; ring])).
  inversion_clear Y as [| ? ? Y0 Y1]. inversion_clear Y1 as [| ? ? Y2 Y3]. inversion_clear Y3 as [| ? ? Y4 Y5].
  inversion_clear Y5 as [| ? ? Y6 _]. cbn [snd] in *. subst x z.
  assert (two : forall u : Qc, ((1+1) * u = 0 -> u = 0)%Qc).
  { intros u F. destruct (Qcmult_integral _ _ F) as [G | G]; [discriminate G | exact G]. }
  rewrite (two w), (two y); [reflexivity | |].
  - rewrite <- Y4. ring.
  - rewrite <- Y0. ring.
Qed.
Definition rationals_known (A : algebra Qc) : knowledge :=
  Knowledge 0 List.nil true true (definite A) true List.nil.
Theorem over_rationals : forall shown st,
  judged (rationals_known (constants st List.nil)) shown st = true -> says (R := Qc) st.
Proof.
  intros shown st E.
  apply (judged_says inv (proj1 rational_field) (proj2 rational_field)
    (rationals_known (constants st List.nil)) shown st
    eq_refl (Forall_nil _) (fun _ => rational_numbers) (fun _ => field_inverses _ _ _ rational_field)
    (definite_norm _) (fun _ => rational_squares)); [intro; constructor | exact E].
Qed.
Theorem rationals_fail : forall st qs ss, fails rational_eqb st qs ss = true -> ~ says (R := Qc) st.
Proof. exact (counterexample _ rational_eqb_is (field_inverses _ _ _ rational_field)). Qed.
Theorem rationals_example : forall st qs ss, succeeds rational_eqb st qs ss = true -> says (R := Qc) st.
Proof. exact (example _ rational_eqb_is (field_inverses _ _ _ rational_field)). Qed.
Theorem integers_fail : forall st qs ss, fails Z.eqb st qs ss = true -> ~ says (R := Z) st.
Proof. exact (counterexample _ Z.eqb_eq integer_units). Qed.
Theorem integers_example : forall st qs ss, succeeds Z.eqb st qs ss = true -> says (R := Z) st.
Proof. exact (example _ Z.eqb_eq integer_units). Qed.

(* The integers: what holds for the rationals, for statements without division. *)
Fixpoint without_units (f : formula) : bool :=
  match f with
  | Equal _ _ | Same _ _ => true | Unit _ => false | Not f => without_units f
  | And f g | Or f g | Imp f g | Iff f g => without_units f && without_units g
  end.
Definition image (z : Z) : Qc := num z.
Lemma image_injective : forall x y, image x = image y -> x = y.
Proof.
  assert (M := gen_phiZ_morph (Eqsth Qc) (Eq_ext add mul opp) Qcrt).
  intros x y E. assert (D : num (R := Qc) (x - y) = zero).
  { etransitivity; [exact (morph_sub M x y) |].
    change (Qcminus (image x) (image y) = Q2Qc 0%Q). rewrite E. ring. }
  apply num_injective in D. lia.
Qed.
Definition of_integers : Inverse Qc := fun x => image (Qfloor (this x)).
Lemma floor_image : forall z, Qfloor (this (image z)) = z.
Proof.
  intro z. unfold image. rewrite num_rational. cbn [this Q2Qc].
  rewrite (Qfloor_comp _ _ (Qred_correct (inject_Z z))). apply Qfloor_Z.
Qed.
Definition over_integers (st : statement) : knowledge :=
  Knowledge 0 List.nil true false (definite (constants (inverse := of_integers) st List.nil)) true List.nil.
Section Integers.
Let rel (x : Qc) (z : Z) : Prop := x = image z.
Let M := gen_phiZ_morph (Eqsth Qc) (Eq_ext add mul opp) Qcrt.
Let terms := fun A A' => rel_terms (inverse := of_integers) rel eq_refl eq_refl
  (fun x x' y y' (E : rel x x') (F : rel y y') => eq_trans (f_equal2 Qcplus E F) (eq_sym (morph_add M x' y')))
  (fun x x' y y' (E : rel x x') (F : rel y y') => eq_trans (f_equal2 Qcminus E F) (eq_sym (morph_sub M x' y')))
  (fun x x' y y' (E : rel x x') (F : rel y y') => eq_trans (f_equal2 Qcmult E F) (eq_sym (morph_mul M x' y')))
  (fun x x' (E : rel x x') => eq_trans (f_equal Qcopp E) (eq_sym (morph_opp M x')))
  (fun x x' (E : rel x x') => f_equal image (eq_trans (f_equal (fun u => Qfloor (this u)) E) (floor_image x'))) A A'.
Lemma holds_over_integers : forall A A' qs qs' ss ss', arel rel A A' -> Forall2 (qrel rel) qs qs' ->
  Forall2 rel ss ss' -> forall f, without_units f = true ->
  (holds (inverse := of_integers) A qs ss f <-> holds A' qs' ss' f).
Proof.
  intros A A' qs qs' ss ss' a q s.
  destruct (terms A A' a qs qs' ss ss' q s) as [S Q].
  induction f; intro E; cbn [without_units] in E; try discriminate; cbn [holds];
    try (apply andb_true_iff in E; destruct E as [E0 E1]; specialize (IHf1 E0); specialize (IHf2 E1); tauto).
  - rewrite (S x), (S y). split; [apply image_injective | intros ->; reflexivity].
  - destruct (Q p) as [P0 [P1 [P2 P3]]], (Q q0) as [Q0 [Q1 [Q2 Q3]]]. split; intro F.
    + apply coordinates; apply image_injective;
        [rewrite <- P0, <- Q0 | rewrite <- P1, <- Q1 | rewrite <- P2, <- Q2 | rewrite <- P3, <- Q3];
        rewrite F; reflexivity.
    + apply coordinates; [rewrite P0, Q0 | rewrite P1, Q1 | rewrite P2, Q2 | rewrite P3, Q3]; rewrite F; reflexivity.
  - specialize (IHf E). tauto.
Qed.
Theorem integers : forall shown st, judged (over_integers st) shown st = true ->
  forallb without_units (List.cons (conclusion st) (given st)) = true -> says (R := Z) st.
Proof.
  intros shown st E W. cbn [forallb] in W. apply andb_true_iff in W; destruct W as [W0 W1].
  assert (F : says (R := Qc) (inverse := of_integers) st).
  { apply (judged_says (inverse := of_integers) Qcinv (proj1 rational_field) (proj2 rational_field) (over_integers st) shown st
      eq_refl (Forall_nil _) (fun _ => rational_numbers)); try discriminate;
      [exact (definite_norm _) | intros _; exact rational_squares | intro; constructor | exact E]. }
  unfold judged in E. repeat (apply andb_true_iff in E; destruct E as [E ?]).
  clear H H0. apply Nat.eqb_eq in H1, H2.
  apply same_for_all; intros qs Wq. apply same_for_all; intros ss Ws.
  unfold says in F. rewrite H1, H2 in *. cbn [there_are] in *. rewrite 2!app_nil_r.
  set (qs' := List.map (fun q => Quaternion (image (re q)) (image (im q)) (image (jm q)) (image (km q))) qs).
  set (ss' := List.map image ss).
  apply (at_values _ _ _ qs') in F; [| unfold qs'; rewrite map_length; exact Wq].
  apply (at_values _ _ _ ss') in F; [| unfold ss'; rewrite map_length; exact Ws].
  rewrite 2!app_nil_r in F.
  assert (Q : Forall2 (qrel rel) qs' qs) by (unfold qs'; clear; induction qs; constructor; [repeat split | assumption]).
  assert (S : Forall2 rel ss' ss) by (unfold ss'; clear; induction ss; constructor; [reflexivity | assumption]).
  assert (A : arel rel (constants (inverse := of_integers) st ss') (constants st ss)).
  { assert (H : arel rel Hamilton Hamilton) by (repeat split; exact eq_refl).
    destruct (terms Hamilton Hamilton H List.nil List.nil ss' ss (Forall2_nil _) S) as [X _].
    repeat split; apply X. }
  assert (T := holds_over_integers _ _ _ _ _ _ A Q S).
  revert F W1. generalize (given st). induction l as [| h hs IH]; cbn [hold_imply forallb]; intros F W1.
  - apply (T _ W0), F.
  - apply andb_true_iff in W1; destruct W1 as [W1 W2]. intro G. apply IH; [| exact W2].
    apply F, (T _ W1), G.
Qed.
End Integers.
Theorem over_the_integers_directly : forall shown st, judged_directly over_rings shown st = true -> says (R := Z) st.
Proof. intros shown st E. exact (direct integer_laws over_rings eq_refl eq_refl eq_refl eq_refl shown st E). Qed.
