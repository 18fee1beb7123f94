/*     CalculiX - A 3-dimensional finite element program                 */
/*     Contact by fmc-contact, by the authors of fmc-contact             */

/*     This program is free software; you can redistribute it and/or     */
/*     modify it under the terms of the GNU General Public License as    */
/*     published by the Free Software Foundation(version 2);             */

/*     This program is distributed in the hope that it will be useful,   */
/*     but WITHOUT ANY WARRANTY; without even the implied warranty of    */
/*     MERCHANTABILITY or FITNESS FOR A PARTICULAR PURPOSE.  See the     */
/*     GNU General Public License for more details.                      */

/* The context of the bodies, and what ccx asks of it: forces, tangent, the end of an increment. */

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include "fmc_ccx.h"

/* Part of an increment that is tried next where contact cannot be measured. */
#define SHORTER 0.5

static fmc_context *context=NULL;
static ITG node_count,row_length,is_frictional,is_written;
static const double *coords;
static double *moved=NULL,*forces=NULL;
static const char *job;
static char *is_solid=NULL;

void fmc_stop(const char *format, ...){
  va_list arguments;
  va_start(arguments,format);
  printf("\n *ERROR in fmc-contact: ");
  vprintf(format,arguments);
  printf("\n\n");
  va_end(arguments);
  fflush(stdout);
  FORTRAN(stop,());
}

void fmc_must(fmc_status status, const char *what){
  if(status!=FMC_OK) fmc_stop("%s: %s (%s)",what,fmc_last_error(),fmc_status_name(status));
}

/* Asked where *CONTACT PAIR is read: 1, if pairs of types that FreeCAD, PrePoMax and Mecway write go to the library. */
void FORTRAN(fmctakes,(ITG *takes)){
  const char *choice=getenv("FMC_CONTACT");
  *takes=(choice==NULL)||(strcmp(choice,"own")!=0);
}

static ITG has_pairs(const char *tieset, ITG ntie){
  ITG i;
  for(i=0;i<ntie;i++) if(tieset[243*i+80]=='F') return 1;
  return 0;
}

void fmc_check_step(const char *tieset, ITG ntie, ITG nmethod, ITG nonlinear, ITG ithermal){
  if(!has_pairs(tieset,ntie)) return;
  if((nmethod!=1)||(!nonlinear)) fmc_stop("contact is known in *STATIC steps without PERTURBATION; FMC_CONTACT=own in the "
					  "environment takes ccx's own contact");
  if(ithermal>1) fmc_stop("contact is not known in steps with temperatures as unknowns");
}

static fmc_coords at(const double *v){
  ITG i,j;
  fmc_coords found={moved,node_count,3,1};
  for(i=0;i<node_count;i++) for(j=0;j<3;j++) moved[3*i+j]=coords[3*i+j]+v[row_length*i+j+1];
  return found;
}

/* Cells by type, with the body of each. */
static void create(const fmc_deck *deck, const fmc_bodies *bodies, const fmc_options *options){
  static const ITG KINDS[]={FMC_HEX8,FMC_HEX20,FMC_TET4,FMC_TET10,FMC_WEDGE6,FMC_WEDGE15};
  fmc_cell_block blocks[6];
  fmc_coords reference={deck->co,deck->nk,3,1};
  ITG i,j,k,type,nodes,*ids=NULL,*conn[6]={NULL},used=0,all=0;

  NNEW(ids,ITG,deck->ne);
  for(k=0;k<6;k++){
    size_t cells=0,length=0;
    NNEW(conn[k],ITG,20*deck->ne);
    for(i=0;i<deck->ne;i++){
      if(bodies->body_of_element[i]<0) continue;
      nodes=fmc_nodes_of(&deck->lakon[8*i],&type);
      if(type!=KINDS[k]) continue;
      for(j=0;j<nodes;j++) conn[k][length++]=deck->kon[deck->ipkon[i]+j];
      ids[all++]=bodies->body_of_element[i];
      cells++;
    }
    if(cells==0) continue;
    blocks[used].cell_type=KINDS[k];
    blocks[used].index_size=sizeof(ITG);
    blocks[used].conn=conn[k];
    blocks[used++].cell_count=cells;
  }
  fmc_must(fmc_context_new_from_cells(3,&reference,blocks,used,ids,options,&context),"mesh");
  SFREE(ids);
  for(k=0;k<6;k++) SFREE(conn[k]);
}

/* Begins a step, and makes the context before the first. 1, if there are pairs of the library. */
ITG fmc_begin(const fmc_deck *deck, ITG mt, const double *vold, const char *jobnamec, ITG *nasym){
  fmc_bodies bodies;
  fmc_options options;
  fmc_coords start;
  ITG i;
  double friction;
  const char *threads=getenv("OMP_NUM_THREADS");

  if(!has_pairs(deck->tieset,deck->ntie)) return 0;
  fmc_find_bodies(deck,&bodies);
  coords=deck->co;row_length=mt;job=jobnamec;
  if(context==NULL){
    node_count=deck->nk;
    fmc_must(fmc_options_init(&options),"options");
    options.law=FMC_LAW_DEPTH;
    options.index_base=1;
    options.check_cells=0;
    if((threads!=NULL)&&(atoi(threads)>1)) options.threads=atoi(threads);
    for(i=0;i<deck->ntie;i++){
      if(deck->tieset[243*i+80]!='F') continue;
      options.stiffness=fmc_pair_stiffness(deck,i,&friction);
      if(friction>0.) is_frictional=1;
    }
    create(deck,&bodies,&options);
    fmc_set_pairs(context,deck,&bodies,&options);
    fmc_must(fmc_context_keep_pattern(context,1),"tangent");
    NNEW(moved,double,3*node_count);
    NNEW(forces,double,3*node_count);
    NNEW(is_solid,char,node_count);
    for(i=0;i<node_count;i++) is_solid[i]=bodies.body_of_node[i+1]>=0;
    printf(" fmc-contact %s: %" ITGFORMAT " bodies%s\n\n",fmc_version(),bodies.count,is_frictional?", with friction":"");
  }
  if(deck->nk!=node_count) fmc_stop("the number of nodes has changed from %" ITGFORMAT " to %" ITGFORMAT,node_count,deck->nk);
  fmc_set_planes(context,deck,&bodies);
  if(is_frictional){
    *nasym=1;
    start=at(vold);
    fmc_must(fmc_context_begin_step(context,&start),"friction");
  }
  SFREE(bodies.body_of_node);SFREE(bodies.body_of_element);
  return 1;
}

/* Takes the forces of contact from the internal forces `fn`. What cannot be measured where the mesh is distorted asks for a shorter
   increment, as a material does by `qa[2]`. */
void fmc_add_forces(const double *v, double *fn, double *qa){
  ITG i,j;
  fmc_coords now;
  fmc_forces out={forces,node_count,3,1};
  fmc_status status;

  if(context==NULL) return;
  now=at(v);
  status=fmc_context_evaluate(context,&now,&out,0,NULL);
  if((status!=FMC_OK)&&((fmc_status_class(status)==FMC_CLASS_GEOMETRY)||(fmc_status_class(status)==FMC_CLASS_NUMERICAL)
			 ||(status==FMC_ERROR_NON_FINITE_COORDINATE))){
    printf(" fmc-contact: %s\n\n",fmc_last_error());
    qa[2]=SHORTER;
    return;
  }
  fmc_must(status,"contact");
  for(i=0;i<node_count;i++) for(j=0;j<3;j++) fn[row_length*i+j+1]-=forces[3*i+j];
}

void fmc_add_tangent(const double *vold, const ITG *nactdof, const ITG *ipompc, const ITG *nodempc, const double *coefmpc,
		     const ITG *neq, ITG *nzs, ITG *icol, ITG *jq, ITG **irowp, double *ad, double **aup, ITG nasym){
  fmc_coords now;
  fmc_result result;

  if(context==NULL) return;
  now=at(vold);
  fmc_must(fmc_context_evaluate_tangent(context,&now,0,NULL,&result,NULL),"contact");
  printf(" fmc-contact: contact elements=%zu, area=%e, penetration=%e\n\n",result.facet_count,result.contact_area,
	 result.penetration);
  fmc_insert(context,node_count,row_length,nactdof,ipompc,nodempc,coefmpc,neq,nzs,icol,jq,irowp,ad,aup,nasym);
}

/* Warnings of the library, and the forces of pairs. */
static void report(const fmc_result *result){
  size_t i;
  int32_t code;
  const char *text;
  fmc_pair_result pair;

  for(i=0;i<result->warning_count;i++){
    fmc_must(fmc_context_warning(context,i,&code,&text),"warning");
    printf(" *WARNING in fmc-contact: %s\n\n",text);
  }
  for(i=0;i<result->pair_count;i++){
    fmc_must(fmc_context_pair_result(context,i,&pair),"pair");
    printf(" fmc-contact: bodies %zu and %zu, area %e, force %e %e %e\n",pair.a+1,pair.b+1,pair.contact_area,pair.force[0],
	   pair.force[1],pair.force[2]);
  }
  printf("\n");
}

/* Displacements, forces and pressures of contact with all digits, at the end of every step: job.fmc.csv. */
static void write_nodes(const double *vold, const fmc_coords *now, ITG istep, double time){
  ITG i;
  double *pressure=NULL;
  fmc_nodal_contact nodal;
  char name[160];
  size_t length=0;
  FILE *file;

  while((length<132)&&(job[length]!=' ')&&(job[length]!='\0')) length++;
  snprintf(name,sizeof name,"%.*s.fmc.csv",(int)length,job);
  file=fopen(name,is_written?"a":"w");
  if(file==NULL) fmc_stop("cannot open %s",name);
  if(!is_written) fprintf(file,"step,time,node,ux,uy,uz,fx,fy,fz,pressure\n");
  is_written=1;
  NNEW(pressure,double,node_count);
  fmc_must(fmc_nodal_contact_init(&nodal),"pressure");
  nodal.pressure=pressure;
  fmc_must(fmc_context_nodal_contact(context,now,&nodal),"pressure");
  for(i=0;i<node_count;i++){
    const double *u=&vold[row_length*i],*f=&forces[3*i];
    if(!is_solid[i]) continue;
    fprintf(file,"%" ITGFORMAT ",%.17g,%" ITGFORMAT ",%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n",istep,time,i+1,u[1],u[2],
	    u[3],f[0],f[1],f[2],pressure[i]);
  }
  SFREE(pressure);
  if(fclose(file)!=0) fmc_stop("cannot write %s",name);
}

/* Accepts an increment; `left` is the part of the step that is left. */
void fmc_end_increment(const double *vold, ITG istep, ITG iinc, double time, double left){
  fmc_coords now;
  fmc_result result;
  fmc_forces out={forces,node_count,3,1};
  (void)iinc;

  if(context==NULL) return;
  now=at(vold);
  fmc_must(fmc_context_evaluate(context,&now,&out,0,&result),"contact");
  report(&result);
  if(is_frictional) fmc_must(fmc_context_commit_step(context,&now),"friction");
  if(left<1.e-6) write_nodes(vold,&now,istep,time);
}
