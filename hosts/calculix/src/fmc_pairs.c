/*     CalculiX - A 3-dimensional finite element program                 */
/*     Contact by fmc-contact, by the authors of fmc-contact             */

/*     This program is free software; you can redistribute it and/or     */
/*     modify it under the terms of the GNU General Public License as    */
/*     published by the Free Software Foundation(version 2);             */

/*     This program is distributed in the hope that it will be useful,   */
/*     but WITHOUT ANY WARRANTY; without even the implied warranty of    */
/*     MERCHANTABILITY or FITNESS FOR A PARTICULAR PURPOSE.  See the     */
/*     GNU General Public License for more details.                      */

/* Contact pairs: which bodies touch, with which stiffness and friction. */

#include <string.h>
#include "fmc_ccx.h"

/* A name without the blanks behind it, and without the letter that says what kind of set it is. */
static size_t name_length(const char *name){
  size_t length=0;
  while((length<81)&&(name[length]!=' ')&&(name[length]!='\0')) length++;
  return length>0?length-1:0;
}

static void mark(const fmc_deck *deck, const fmc_bodies *bodies, const char *name, char kind, ITG value, char *is_of){
  ITG element=value,type,body;
  int length=(int)name_length(name);

  if(kind=='T'){
    element=value/10;
    body=bodies->body_of_element[element-1];
    if(body<0){
      if(fmc_nodes_of(&deck->lakon[8*(element-1)],&type)>0) return;
      fmc_stop("surface %.*s has a face of element %" ITGFORMAT " of type %.8s; fmc-contact takes C3D4, C3D6, C3D8, C3D10, "
	       "C3D15, C3D20 and their variants, and FMC_CONTACT=own in the environment takes ccx's own contact",
	       length,name,element,&deck->lakon[8*(element-1)]);
    }
  }else{
    body=bodies->body_of_node[value];
    if(body<0) fmc_stop("node %" ITGFORMAT " of surface %.*s belongs to no solid element",value,length,name);
  }
  is_of[body]=1;
}

/* Bodies on which a surface of faces or nodes lies. */
static void bodies_of(const fmc_deck *deck, const fmc_bodies *bodies, const char *name, char *is_of){
  ITG i,j,k;
  size_t length=name_length(name);
  char kind;
  const char *found;

  memset(is_of,0,bodies->count);
  for(i=0;i<deck->nset;i++){
    found=&deck->set[81*i];
    if((name_length(found)!=length)||(strncmp(found,name,length)!=0)) continue;
    kind=found[length];
    if((kind!='T')&&(kind!='S')) continue;
    for(j=deck->istartset[i]-1;j<deck->iendset[i];j++){
      if(deck->ialset[j]>0){
	mark(deck,bodies,name,kind,deck->ialset[j],is_of);
      }else{
	for(k=deck->ialset[j-2]-deck->ialset[j];k<deck->ialset[j-1];k-=deck->ialset[j])
	  mark(deck,bodies,name,kind,k,is_of);
      }
    }
    return;
  }
  fmc_stop("there is no surface %.*s",(int)length,name);
}

/* Pressure by penetration of a pair, and its coefficient of friction, 0 for none. */
double fmc_pair_stiffness(const fmc_deck *deck, ITG tie, double *friction){
  ITG material=(ITG)deck->tietol[4*tie+1]-1;
  const double *found=&deck->elcon[(deck->ncmat_+1)*deck->ntmat_*material];
  ITG law=deck->ncmat_>=3?(ITG)found[3]:0;

  if(law==4) fmc_stop("PRESSURE-OVERCLOSURE=TIED is not known to fmc-contact: use *TIE");
  if(law!=2) fmc_stop("PRESSURE-OVERCLOSURE is known to fmc-contact as LINEAR with a slope, or HARD");
  *friction=deck->ncmat_>=7?found[6]:0.;
  return found[2];
}

void fmc_set_pairs(fmc_context *context, const fmc_deck *deck, const fmc_bodies *bodies, const fmc_options *options){
  ITG tie,a,b,count=bodies->count,is_self,pairs;
  char *of_a=NULL,*of_b=NULL;
  fmc_pair_options pair;

  NNEW(of_a,char,count);
  NNEW(of_b,char,count);
  fmc_must(fmc_pair_options_init(&pair),"*CONTACT PAIR");
  pair.excluded=1;
  for(a=0;a<count;a++) for(b=a+1;b<count;b++)
    fmc_must(fmc_context_set_pair_options(context,FMC_PARTNER_BODY,a,FMC_PARTNER_BODY,b,&pair),"*CONTACT PAIR");
  for(tie=0;tie<deck->ntie;tie++){
    const char *slave=&deck->tieset[243*tie+81],*master=slave+81;
    double friction;
    if(deck->tieset[243*tie+80]!='F') continue;
    if((deck->tietol[4*tie]>=2.)||(deck->tietol[4*tie]<=-2.)||(deck->tieset[243*tie]!=' '))
      fmc_stop("ADJUST of *CONTACT PAIR is not known to fmc-contact in ccx");
    fmc_must(fmc_pair_options_init(&pair),"*CONTACT PAIR");
    pair.law=options->law;
    pair.stiffness=fmc_pair_stiffness(deck,tie,&friction);
    if(friction>0.) pair.friction_coefficient=friction;
    bodies_of(deck,bodies,slave,of_a);
    bodies_of(deck,bodies,master,of_b);
    is_self=(name_length(slave)==name_length(master))&&(strncmp(slave,master,name_length(slave))==0);
    pairs=0;
    for(a=0;a<count;a++) for(b=0;b<count;b++){
	if((!of_a[a])||(!of_b[b])||((a==b)&&(!is_self))) continue;
	fmc_must(fmc_context_set_pair_options(context,FMC_PARTNER_BODY,a,FMC_PARTNER_BODY,b,&pair),"*CONTACT PAIR");
	pairs++;
      }
    if(pairs==0) fmc_stop("%.*s and %.*s are surfaces of one body",(int)name_length(slave),slave,
			  (int)name_length(master),master);
  }
  SFREE(of_a);SFREE(of_b);
}
