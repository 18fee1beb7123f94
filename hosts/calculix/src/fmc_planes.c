/*     CalculiX - A 3-dimensional finite element program                 */
/*     Contact by fmc-contact, by the authors of fmc-contact             */

/*     This program is free software; you can redistribute it and/or     */
/*     modify it under the terms of the GNU General Public License as    */
/*     published by the Free Software Foundation(version 2);             */

/*     This program is distributed in the hope that it will be useful,   */
/*     but WITHOUT ANY WARRANTY; without even the implied warranty of    */
/*     MERCHANTABILITY or FITNESS FOR A PARTICULAR PURPOSE.  See the     */
/*     GNU General Public License for more details.                      */

/* Planes of symmetry, as supports make them: planes x, y or z = const that bound the model, all of whose faces are held
   across them. Nothing can come to such faces from behind, so they are no surface that contact could press. fmc solve
   has the same rule. */

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "fmc_ccx.h"

/* Part of the size of all bodies up to which a node lies in a plane: files have seven digits. */
#define IN_PLANE 1.e-6

/* Nodes of faces, corners first; 0 ends a row. */
static const ITG HEX[6][9]={{1,2,3,4,9,10,11,12},{5,8,7,6,16,15,14,13},{1,5,6,2,17,13,18,9},
			    {2,6,7,3,18,14,19,10},{3,7,8,4,19,15,20,11},{4,8,5,1,20,16,17,12}};
static const ITG TET[6][9]={{1,2,3,5,6,7},{1,4,2,8,9,5},{2,4,3,9,10,6},{3,4,1,10,8,7}};
static const ITG WEDGE[6][9]={{1,2,3,7,8,9},{4,6,5,12,11,10},{1,4,5,2,13,10,14,7},{2,5,6,3,14,11,15,8},{3,6,4,1,15,12,13,9}};

/* Number of nodes of a face of a cell, 0 where it has no such face; `*nodes` are counted from 1. */
ITG fmc_face(ITG cell_type, ITG face, const ITG **nodes){
  ITG of_cell=0,count=0;
  switch(cell_type){
  case FMC_HEX8: of_cell=8;*nodes=HEX[face];break;
  case FMC_HEX20: of_cell=20;*nodes=HEX[face];break;
  case FMC_TET4: of_cell=4;*nodes=TET[face];break;
  case FMC_TET10: of_cell=10;*nodes=TET[face];break;
  case FMC_WEDGE6: of_cell=6;*nodes=WEDGE[face];break;
  case FMC_WEDGE15: of_cell=15;*nodes=WEDGE[face];break;
  default: return 0;
  }
  while((count<8)&&((*nodes)[count]>0)&&((*nodes)[count]<=of_cell)) count++;
  return count;
}

/* A face by its corners, ascending, and where it stands. */
typedef struct {
  ITG corners[4],element,face;
} facet;

static int compare(const void *a, const void *b){
  const facet *p=a,*q=b;
  ITG i;
  for(i=0;i<4;i++) if(p->corners[i]!=q->corners[i]) return p->corners[i]<q->corners[i]?-1:1;
  return 0;
}

static facet facet_of(const fmc_deck *deck, ITG element, ITG face, ITG cell_type, const ITG *nodes, ITG count){
  facet found={{0,0,0,0},element,face};
  ITG i,j,k,corners=((cell_type==FMC_TET4)||(cell_type==FMC_TET10)||(count==3)||(count==6))?3:4;
  for(i=0;i<corners;i++){
    k=deck->kon[deck->ipkon[element]+nodes[i]-1];
    for(j=3;(j>0)&&(found.corners[j]>k);j--) {}
    memmove(found.corners,found.corners+1,j*sizeof(ITG));
    found.corners[j]=k;
  }
  return found;
}

/* Faces that belong to one element only. */
static ITG boundary(const fmc_deck *deck, facet **facesp){
  ITG i,face,type,count,n=0,kept=0;
  const ITG *nodes;
  facet *faces=NULL;
  NNEW(faces,facet,6*deck->ne);
  for(i=0;i<deck->ne;i++){
    if((deck->ipkon[i]<0)||(fmc_nodes_of(&deck->lakon[8*i],&type)==0)) continue;
    for(face=0;face<6;face++){
      count=fmc_face(type,face,&nodes);
      if(count>0) faces[n++]=facet_of(deck,i,face,type,nodes,count);
    }
  }
  qsort(faces,n,sizeof(facet),compare);
  for(i=0;i<n;i++){
    if((i>0)&&(compare(&faces[i-1],&faces[i])==0)) continue;
    if((i+1<n)&&(compare(&faces[i],&faces[i+1])==0)) continue;
    faces[kept++]=faces[i];
  }
  *facesp=faces;
  return kept;
}

/* Which nodes never moved along which axis, in all steps until now: 3 bytes for each. */
static char *held=NULL;

static void take_supports(const fmc_deck *deck){
  ITG i,is_first=held==NULL;
  char *now=NULL;
  NNEW(now,char,3*(deck->nk+1));
  for(i=0;i<deck->nboun;i++){
    if((deck->ndirboun[i]<1)||(deck->ndirboun[i]>3)) continue;
    now[3*deck->nodeboun[i]+deck->ndirboun[i]-1]=(deck->xboun[i]==0.)&&(deck->xbounold[i]==0.);
  }
  if(is_first) NNEW(held,char,3*(deck->nk+1));
  for(i=0;i<3*(deck->nk+1);i++) held[i]=now[i]&&(is_first||held[i]);
  SFREE(now);
}

void fmc_set_planes(fmc_context *context, const fmc_deck *deck, const fmc_bodies *bodies){
  ITG i,j,axis,end,n,type,count,node,found=0,is_in,is_held,is_plane;
  const ITG *nodes;
  facet *faces=NULL;
  double ends[3][2]={{INFINITY,-INFINITY},{INFINITY,-INFINITY},{INFINITY,-INFINITY}},size=0.,x,points[18],normals[18];
  fmc_status status;

  take_supports(deck);
  for(node=1;node<=deck->nk;node++){
    if(bodies->body_of_node[node]<0) continue;
    for(axis=0;axis<3;axis++){
      x=deck->co[3*(node-1)+axis];
      if(x<ends[axis][0]) ends[axis][0]=x;
      if(x>ends[axis][1]) ends[axis][1]=x;
    }
  }
  for(axis=0;axis<3;axis++) if(ends[axis][1]-ends[axis][0]>size) size=ends[axis][1]-ends[axis][0];
  n=boundary(deck,&faces);
  for(axis=0;axis<3;axis++) for(end=0;end<2;end++){
      is_plane=0;
      for(i=0;i<n;i++){
	fmc_nodes_of(&deck->lakon[8*faces[i].element],&type);
	count=fmc_face(type,faces[i].face,&nodes);
	is_in=is_held=1;
	for(j=0;j<count;j++){
	  node=deck->kon[deck->ipkon[faces[i].element]+nodes[j]-1];
	  if(fabs(deck->co[3*(node-1)+axis]-ends[axis][end])>IN_PLANE*size) is_in=0;
	  if(!held[3*node+axis]) is_held=0;
	}
	if(!is_in) continue;
	is_plane=is_held;
	if(!is_held) break;
      }
      if(!is_plane) continue;
      for(j=0;j<3;j++){points[3*found+j]=j==axis?ends[axis][end]:0.;normals[3*found+j]=j==axis?1.:0.;}
      found++;
    }
  SFREE(faces);
  /* A body that would have no surface left: none is a plane of symmetry then. */
  status=fmc_context_set_symmetry_planes(context,points,normals,found);
  if(status==FMC_ERROR_UNSUPPORTED) status=fmc_context_set_symmetry_planes(context,points,normals,0);
  fmc_must(status,"planes of symmetry");
}
