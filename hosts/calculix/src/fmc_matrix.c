/*     CalculiX - A 3-dimensional finite element program                 */
/*     Contact by fmc-contact, by the authors of fmc-contact             */

/*     This program is free software; you can redistribute it and/or     */
/*     modify it under the terms of the GNU General Public License as    */
/*     published by the Free Software Foundation(version 2);             */

/*     This program is distributed in the hope that it will be useful,   */
/*     but WITHOUT ANY WARRANTY; without even the implied warranty of    */
/*     MERCHANTABILITY or FITNESS FOR A PARTICULAR PURPOSE.  See the     */
/*     GNU General Public License for more details.                      */

/* The tangent of contact in the matrix of ccx: columns of what is below the diagonal, rows ascending. Contact couples nodes
   that no element joins, so places are added where the matrix has none. */

#include <stdlib.h>
#include <string.h>
#include "fmc_ccx.h"

/* An entry below the diagonal, and the one across. */
typedef struct {
  ITG row,col;
  double low,high;
} entry;

typedef struct {
  const ITG *nactdof,*ipompc,*nodempc;
  const double *coefmpc;
  ITG mt;
} equations;

static int compare(const void *a, const void *b){
  const entry *p=a,*q=b;
  if(p->col!=q->col) return p->col<q->col?-1:1;
  return p->row<q->row?-1:p->row>q->row;
}

/* Equations, from 1, and factors on which a degree of freedom depends: itself, those of its equation of constraint, or none. */
static ITG terms_of(const equations *of, ITG dof, ITG **eqs, double **factors, ITG *room){
  ITG count=0,first,index,found=of->nactdof[of->mt*(dof/3)+dof%3+1];
  if(found>0){
    (*eqs)[0]=found;(*factors)[0]=1.;
    return 1;
  }
  if((found==0)||(found%2==0)) return 0;
  first=of->ipompc[(1-found)/2-1]-1;
  for(index=of->nodempc[3*first+2]-1;index>=0;index=of->nodempc[3*index+2]-1){
    ITG eq=of->nactdof[of->mt*(of->nodempc[3*index]-1)+of->nodempc[3*index+1]];
    if(eq<=0) continue;
    if(count==*room){
      *room*=2;
      RENEW(*eqs,ITG,*room);
      RENEW(*factors,double,*room);
    }
    (*eqs)[count]=eq;
    (*factors)[count++]=-of->coefmpc[index]/of->coefmpc[first];
  }
  return count;
}

/* Entries of the tangent in equations; what is on the diagonal is added to `ad` at once. */
static ITG entries_of(fmc_context *context, ITG nk, const equations *of, double *ad, entry **entriesp){
  size_t count=0,offsets=0;
  ITG row,k,i,j,rows,cols,n=0,room=1024,*offset=NULL,*col=NULL,room_a=8,room_b=8,*a=NULL,*b=NULL;
  double *value=NULL,*fa=NULL,*fb=NULL;
  entry *entries=NULL;

  fmc_must(fmc_context_tangent_csr(context,0,NULL,0,&offsets,NULL,NULL,0,&count),"tangent");
  NNEW(offset,ITG,offsets);NNEW(col,ITG,count+1);NNEW(value,double,count+1);
  fmc_must(fmc_context_tangent_csr(context,0,offset,offsets,&offsets,col,value,count,&count),"tangent");
  NNEW(entries,entry,room);
  NNEW(a,ITG,room_a);NNEW(fa,double,room_a);NNEW(b,ITG,room_b);NNEW(fb,double,room_b);
  for(row=0;row<3*nk;row++){
    if(offset[row]==offset[row+1]) continue;
    rows=terms_of(of,row,&a,&fa,&room_a);
    for(k=offset[row]-1;(rows>0)&&(k<offset[row+1]-1);k++){
      cols=terms_of(of,col[k]-1,&b,&fb,&room_b);
      for(i=0;i<rows;i++) for(j=0;j<cols;j++){
	  double found=fa[i]*fb[j]*value[k];
	  if(a[i]==b[j]){ad[a[i]-1]+=found;continue;}
	  if(n==room){room*=2;RENEW(entries,entry,room);}
	  entries[n].row=a[i]>b[j]?a[i]:b[j];
	  entries[n].col=a[i]>b[j]?b[j]:a[i];
	  entries[n].low=a[i]>b[j]?found:0.;
	  entries[n++].high=a[i]>b[j]?0.:found;
	}
    }
  }
  SFREE(offset);SFREE(col);SFREE(value);SFREE(a);SFREE(b);SFREE(fa);SFREE(fb);
  qsort(entries,n,sizeof(entry),compare);
  for(i=0,k=-1;i<n;i++){
    if((k>=0)&&(compare(&entries[k],&entries[i])==0)){
      entries[k].low+=entries[i].low;
      entries[k].high+=entries[i].high;
    }else entries[++k]=entries[i];
  }
  *entriesp=entries;
  return k+1;
}

void fmc_insert(fmc_context *context, ITG nk, ITG mt, const ITG *nactdof, const ITG *ipompc, const ITG *nodempc,
		const double *coefmpc, const ITG *neq, ITG *nzs, ITG *icol, ITG *jq, ITG **irowp, double *ad,
		double **aup, ITG nasym){
  const equations of={nactdof,ipompc,nodempc,coefmpc,mt};
  entry *entries=NULL;
  ITG n=entries_of(context,nk,&of,ad,&entries),old=jq[neq[1]]-1,most=old+n,parts=nasym?2:1,at=0,e=0,c,k,start,end;
  ITG *irow=NULL,*before=*irowp;
  double *au=NULL,*values=*aup;

  NNEW(irow,ITG,most+1);
  NNEW(au,double,parts*(most+1));
  for(c=0;c<neq[1];c++){
    start=at;
    k=jq[c]-1;end=jq[c+1]-1;
    while((k<end)||((e<n)&&(entries[e].col==c+1))){
      ITG has_entry=(e<n)&&(entries[e].col==c+1);
      ITG takes_old=(k<end)&&((!has_entry)||(before[k]<=entries[e].row));
      ITG takes_new=has_entry&&((k>=end)||(entries[e].row<=before[k]));
      irow[at]=takes_old?before[k]:entries[e].row;
      if(takes_old){
	au[at]=values[k];
	if(nasym) au[most+1+at]=values[nzs[2]+k];
	k++;
      }
      if(takes_new){
	au[at]+=entries[e].low;
	if(nasym) au[most+1+at]+=entries[e].high;
	e++;
      }
      at++;
    }
    jq[c]=start+1;
    icol[c]=at-start;
  }
  jq[neq[1]]=at+1;
  if(nasym) memmove(&au[at],&au[most+1],at*sizeof(double));
  nzs[0]=nzs[1]=nzs[2]=at;
  SFREE(entries);SFREE(before);SFREE(values);
  *irowp=irow;*aup=au;
}
