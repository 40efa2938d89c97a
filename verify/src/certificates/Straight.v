(* Polynomial identities over the real numbers by the theorem behind Coq's tactic `ring` (Ring_polynom.norm_aux_spec), with
   rational coefficients. The tactic looks for the expressions in the goal, which takes minutes for a program of a thousand
   steps; here the expressions are written down beside the goal, and coqc checks that they are the goal's. *)

From Coq Require Import Ring_polynom Ring_theory List ZArith QArith Qreals Qreduction Reals.
Open Scope R_scope.

(* A coefficient as a real number: n, or n/d. *)
Definition number (q : Q) : R :=
  match Qden q with
  | xH => IZR (Qnum q)
  | d => IZR (Qnum q) / IZR (Zpos d)
  end.

Lemma number_is : forall q, number q = Q2R q.
Proof.
  intros [n d]; unfold number, Q2R; cbn [Qnum Qden].
  destruct d; try reflexivity.
  rewrite Rinv_1; ring.
Qed.

(* Coefficients are kept in lowest terms. *)
Definition add (p q : Q) := Qred (p + q).
Definition mul (p q : Q) := Qred (p * q).
Definition sub (p q : Q) := Qred (p - q).

Lemma reduced : forall q, Q2R (Qred q) = Q2R q.
Proof. intros; apply Qeq_eqR, Qred_correct. Qed.

Lemma numbers : ring_morph 0 1 Rplus Rmult Rminus Ropp (@eq R)
  0%Q 1%Q add mul sub Qopp Qeq_bool number.
Proof.
  constructor; intros; rewrite ?number_is; unfold add, mul, sub; rewrite ?reduced.
  - unfold Q2R; cbn; ring.
  - unfold Q2R; cbn; rewrite Rinv_1; ring.
  - apply Q2R_plus.
  - apply Q2R_minus.
  - apply Q2R_mult.
  - apply Q2R_opp.
  - apply Qeq_eqR, Qeq_bool_eq; assumption.
Qed.

Definition reals := Rth_ARth (Eqsth R) (Eq_ext Rplus Rmult Ropp) RTheory.

(* Expressions, and what they are worth where the k-th input is the k-th number of a list. *)
Definition expression := PExpr Q.
Definition value : list R -> expression -> R :=
  PEeval 0 1 Rplus Rmult Rminus Ropp number (fun n : N => n) (pow_N 1 Rmult).

Definition input : positive -> expression := PEX Q.
Definition constant : Q -> expression := @PEc Q.

Declare Scope expression_scope.
Delimit Scope expression_scope with E.
Bind Scope expression_scope with expression.
Notation "a + b" := (@PEadd Q a b) : expression_scope.
Notation "a - b" := (@PEsub Q a b) : expression_scope.
Notation "a * b" := (@PEmul Q a b) : expression_scope.
Notation "- a" := (@PEopp Q a) : expression_scope.

(* The polynomials that they are. *)
Definition polynomial : expression -> Pol Q :=
  norm_aux 0%Q 1%Q add mul sub Qopp Qeq_bool.
Definition agree (a b : expression) : bool := Peq Qeq_bool (polynomial a) (polynomial b).

Theorem same : forall (numbers : list R) (a b : expression),
  agree a b = true -> value numbers a = value numbers b.
Proof.
  intros l a b H; unfold value.
  rewrite !(norm_aux_spec (Eqsth R) (Eq_ext Rplus Rmult Ropp) reals numbers
    (pow_N_th 1 Rmult (Eqsth R))).
  apply (Peq_ok (Eqsth R) (Eq_ext Rplus Rmult Ropp) numbers); exact H.
Qed.

(* Short programs and quotients: the tactic `field`. What is divided by is a sum of products of positive numbers. *)
From Coq Require Import Lra Psatz.
Ltac positive :=
  repeat first [assumption | lra | apply Rmult_lt_0_compat | apply Rplus_lt_0_compat].
Ltac nonzero := apply Rgt_not_eq; unfold Rgt; solve [positive | nra].
Ltac by_field := cbv zeta; intros; field; repeat split; nonzero.
