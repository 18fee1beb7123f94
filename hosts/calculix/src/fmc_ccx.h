/*     CalculiX - A 3-dimensional finite element program                 */
/*     Contact by fmc-contact, by the authors of fmc-contact             */

/*     This program is free software; you can redistribute it and/or     */
/*     modify it under the terms of the GNU General Public License as    */
/*     published by the Free Software Foundation(version 2);             */

/*     This program is distributed in the hope that it will be useful,   */
/*     but WITHOUT ANY WARRANTY; without even the implied warranty of    */
/*     MERCHANTABILITY or FITNESS FOR A PARTICULAR PURPOSE.  See the     */
/*     GNU General Public License for more details.                      */

/* Contact of CalculiX by fmc-contact: what the patched program calls.
   Pairs of the library are marked 'F' in the last place of tieset(1,*), where ccx has 'C' for its own. */

#ifndef FMC_CCX_H
#define FMC_CCX_H

#include <stdio.h>
#include "CalculiX.h"
#include "fmc_contact.h"

/* What is known of the deck where a step begins, in the words of nonlingeo. */
typedef struct {
  const double *co;
  ITG nk;
  const ITG *kon, *ipkon;
  const char *lakon;
  ITG ne;
  const char *tieset;
  ITG ntie;
  const double *tietol;
  const char *set;
  ITG nset;
  const ITG *istartset, *iendset, *ialset;
  const double *elcon;
  ITG ncmat_, ntmat_;
  const ITG *nodeboun, *ndirboun;
  const double *xboun, *xbounold;
  ITG nboun;
} fmc_deck;

/* Solid elements of the deck, and the body of every node and element, from 0; -1: none. */
typedef struct {
  ITG *body_of_node, *body_of_element;
  ITG count;
} fmc_bodies;

/* Calls of the patch. Every one is without effect where no pair is the library's. */
void fmc_check_step(const char *tieset, ITG ntie, ITG nmethod, ITG nonlinear, ITG ithermal);
ITG fmc_begin(const fmc_deck *deck, ITG mt, const double *vold, const char *jobnamec, ITG *nasym);
void fmc_add_forces(const double *v, double *fn, double *qa);
void fmc_add_tangent(const double *vold, const ITG *nactdof, const ITG *ipompc, const ITG *nodempc, const double *coefmpc,
		     const ITG *neq, ITG *nzs, ITG *icol, ITG *jq, ITG **irowp, double *ad, double **aup, ITG nasym);
void fmc_end_increment(const double *vold, ITG istep, ITG iinc, double time, double left);

/* Parts of it. */
ITG fmc_nodes_of(const char *lakon, ITG *cell_type);
ITG fmc_face(ITG cell_type, ITG face, const ITG **nodes);
void fmc_find_bodies(const fmc_deck *deck, fmc_bodies *bodies);
void fmc_set_pairs(fmc_context *context, const fmc_deck *deck, const fmc_bodies *bodies, const fmc_options *options);
double fmc_pair_stiffness(const fmc_deck *deck, ITG tie, double *friction);
void fmc_set_planes(fmc_context *context, const fmc_deck *deck, const fmc_bodies *bodies);
void fmc_insert(fmc_context *context, ITG nk, ITG mt, const ITG *nactdof, const ITG *ipompc, const ITG *nodempc,
		const double *coefmpc, const ITG *neq, ITG *nzs, ITG *icol, ITG *jq, ITG **irowp, double *ad,
		double **aup, ITG nasym);

/* Ends ccx as it ends at its own errors. */
void fmc_stop(const char *format, ...);
/* Ends ccx with the library's text, if a call failed. */
void fmc_must(fmc_status status, const char *what);

#endif
