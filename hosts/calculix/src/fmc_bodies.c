/*     CalculiX - A 3-dimensional finite element program                 */
/*     Contact by fmc-contact, by the authors of fmc-contact             */

/*     This program is free software; you can redistribute it and/or     */
/*     modify it under the terms of the GNU General Public License as    */
/*     published by the Free Software Foundation(version 2);             */

/*     This program is distributed in the hope that it will be useful,   */
/*     but WITHOUT ANY WARRANTY; without even the implied warranty of    */
/*     MERCHANTABILITY or FITNESS FOR A PARTICULAR PURPOSE.  See the     */
/*     GNU General Public License for more details.                      */

/* Bodies: the parts of the mesh of solid elements that share nodes. */

#include <string.h>
#include "fmc_ccx.h"

static const struct {
  const char *name;
  ITG nodes, cell_type;
} KINDS[]={{"20",20,FMC_HEX20},{"8",8,FMC_HEX8},{"10",10,FMC_TET10},{"4",4,FMC_TET4},{"15",15,FMC_WEDGE15},{"6",6,FMC_WEDGE6}};

/* Number of nodes of a solid element that the library takes, and its cell type; 0 for all others: plane, axisymmetric,
   shell and beam elements, which ccx expands, have a letter in the seventh place. */
ITG fmc_nodes_of(const char *lakon, ITG *cell_type){
  size_t i;
  if(strncmp(lakon,"C3D",3)!=0) return 0;
  if((lakon[6]!=' ')&&(lakon[6]!='\0')&&(lakon[6]!='T')) return 0;
  for(i=0;i<sizeof KINDS/sizeof KINDS[0];i++){
    if(strncmp(lakon+3,KINDS[i].name,strlen(KINDS[i].name))==0){
      *cell_type=KINDS[i].cell_type;
      return KINDS[i].nodes;
    }
  }
  return 0;
}

static ITG root(ITG *parent, ITG node){
  while(parent[node]!=node){
    parent[node]=parent[parent[node]];
    node=parent[node];
  }
  return node;
}

void fmc_find_bodies(const fmc_deck *deck, fmc_bodies *bodies){
  ITG i,j,nodes,kind,first,*parent=NULL,*number=NULL;

  NNEW(parent,ITG,deck->nk+1);
  NNEW(number,ITG,deck->nk+1);
  NNEW(bodies->body_of_node,ITG,deck->nk+1);
  NNEW(bodies->body_of_element,ITG,deck->ne);
  for(i=0;i<=deck->nk;i++){parent[i]=i;number[i]=-1;bodies->body_of_node[i]=-1;}
  bodies->count=0;
  for(i=0;i<deck->ne;i++){
    if(deck->ipkon[i]<0) continue;
    nodes=fmc_nodes_of(&deck->lakon[8*i],&kind);
    for(j=1;j<nodes;j++){
      first=root(parent,deck->kon[deck->ipkon[i]]);
      parent[root(parent,deck->kon[deck->ipkon[i]+j])]=first;
    }
  }
  for(i=0;i<deck->ne;i++){
    bodies->body_of_element[i]=-1;
    if(deck->ipkon[i]<0) continue;
    nodes=fmc_nodes_of(&deck->lakon[8*i],&kind);
    if(nodes==0) continue;
    first=root(parent,deck->kon[deck->ipkon[i]]);
    if(number[first]<0) number[first]=bodies->count++;
    bodies->body_of_element[i]=number[first];
    for(j=0;j<nodes;j++) bodies->body_of_node[deck->kon[deck->ipkon[i]+j]]=number[first];
  }
  SFREE(parent);SFREE(number);
}
