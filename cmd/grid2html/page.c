/* page.c - the parts of the page, one after the other. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/base/base64.h"
#include "../../lib/picture/colourmap.h"
#include "../shared/json.h"
#include "page.h"

static const char *const head[] = {
"<!DOCTYPE html>",
"<html lang=\"en\"><head><meta charset=\"utf-8\"><title>lhgrid</title>",
"<meta name=\"viewport\" content=\"width=device-width\">",
"<style>",
"body{margin:0;overflow:hidden;font:14px sans-serif;background:#fff;color:#222}",
"canvas{display:block;outline:none}",
"#bar{position:absolute;left:0;right:0;bottom:0;padding:8px 12px;background:rgba(255,255,255,.85);display:flex;",
"gap:14px;align-items:center;flex-wrap:wrap}",
"#bar input[type=range]{flex:1;min-width:120px}",
".name{position:absolute;top:8px;padding:0 12px}",
"#key{width:160px;height:12px;border:1px solid #888}",
"</style></head><body>",
"<div class=\"name\" id=\"nameA\" style=\"left:0\"></div>",
"<div class=\"name\" id=\"nameB\" style=\"left:50%\"></div>",
"<div id=\"bar\"><label id=\"frames\">frame <b id=\"number\"></b></label>",
"<input type=\"range\" id=\"frame\" min=\"0\" value=\"0\">",
"<button id=\"play\">play</button><label>colour <select id=\"field\"></select></label>",
"<span id=\"low\"></span><canvas id=\"key\" width=\"160\" height=\"12\"></canvas><span id=\"high\"></span>",
"<label><input type=\"checkbox\" id=\"edges\"> edges</label></div>",
NULL };

static const char *const script[] = {
"'use strict';",
"function bytes(s){const b=atob(s),n=b.length,a=new Uint8Array(n);",
"  for(let i=0;i<n;i++)a[i]=b.charCodeAt(i);return a.buffer}",
"const little=new Uint8Array(new Uint32Array([1]).buffer)[0]===1;",
"if(!little)alert('this page needs a little-endian machine');",
"const maps=DATA.maps.map(m=>new Uint8Array(bytes(m)));",
"const renderer=new THREE.WebGLRenderer({antialias:true,preserveDrawingBuffer:true});",
"renderer.setPixelRatio(window.devicePixelRatio);renderer.setScissorTest(true);",
"document.body.insertBefore(renderer.domElement,document.body.firstChild);",
"const camera=new THREE.PerspectiveCamera(35,1,1e-3,1e3);",
"const controls=new THREE.OrbitControls(camera,renderer.domElement);",
"const views=DATA.surfaces.map(function(s){",
"  const v={s:s,xyz:new Float32Array(bytes(s.xyz)),fields:{}};",
"  s.fields.forEach(f=>v.fields[f.name]={f:f,values:new Float32Array(bytes(f.values))});",
"  v.geometry=new THREE.BufferGeometry();",
"  v.geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(bytes(s.tri)),1));",
"  v.geometry.setAttribute('position',new THREE.BufferAttribute(new Float32Array(3*s.vertices),3));",
"  v.geometry.setAttribute('color',new THREE.BufferAttribute(new Float32Array(3*s.vertices),3));",
"  v.scene=new THREE.Scene();v.scene.background=new THREE.Color(0xffffff);",
"  v.mesh=new THREE.Mesh(v.geometry,new THREE.MeshLambertMaterial({",
"    vertexColors:THREE.VertexColors,side:THREE.DoubleSide}));",
"  v.lines=new THREE.Mesh(v.geometry,new THREE.MeshBasicMaterial({",
"    color:0x222222,wireframe:true,transparent:true,opacity:.25}));",
"  v.lines.visible=false;v.scene.add(v.mesh,v.lines,new THREE.AmbientLight(0xffffff,.45));",
"  v.light=new THREE.DirectionalLight(0xffffff,.65);v.scene.add(v.light);return v});",
"const frames=Math.max(...DATA.surfaces.map(s=>s.frames));",
"function colour(v,k){",
"  const c=v.geometry.attributes.color.array,",
"    name=document.getElementById('field').value,e=v.fields[name],n=v.s.vertices;",
"  for(let i=0;i<n;i++){",
"    let r=.84,g=.82,b=.78;",
"    if(e){const x=e.values[k*n+i],f=e.f,m=maps[f.diverging],last=m.length/3-1;",
"      let t=f.high>f.low?(x-f.low)/(f.high-f.low):.5;t=Math.min(Math.max(t,0),1);",
"      const j=3*Math.round(t*last);if(x===x){r=m[j]/255;g=m[j+1]/255;b=m[j+2]/255}}",
"    c[3*i]=r;c[3*i+1]=g;c[3*i+2]=b}",
"  v.geometry.attributes.color.needsUpdate=true}",
"function show(k){",
"  document.getElementById('number').textContent=(k+1)+' of '+frames;",
"  views.forEach(function(v){const l=Math.min(k,v.s.frames-1),n=3*v.s.vertices;",
"    v.geometry.attributes.position.array.set(v.xyz.subarray(l*n,l*n+n));",
"    v.geometry.attributes.position.needsUpdate=true;",
"    v.geometry.computeVertexNormals();v.geometry.computeBoundingSphere();colour(v,l)});key();draw()}",
"function key(){",
"  const name=document.getElementById('field').value,",
"    v=views.find(v=>v.fields[name]),c=document.getElementById('key').getContext('2d');",
"  c.clearRect(0,0,160,12);",
"  document.getElementById('low').textContent=document.getElementById('high').textContent='';",
"  if(!v)return;const f=v.fields[name].f,m=maps[f.diverging],last=m.length/3-1;",
"  for(let i=0;i<160;i++){const j=3*Math.round(i/159*last);",
"    c.fillStyle='rgb('+m[j]+','+m[j+1]+','+m[j+2]+')';c.fillRect(i,0,1,12)}",
"  document.getElementById('low').textContent=f.low.toPrecision(3);",
"    document.getElementById('high').textContent=f.high.toPrecision(3)}",
"function draw(){",
"  const w=window.innerWidth,h=window.innerHeight,n=views.length;renderer.setSize(w,h);",
"  camera.aspect=w/n/h;camera.updateProjectionMatrix();",
"  views.forEach(function(v,i){",
"    v.light.position.copy(camera.position).add(new THREE.Vector3(-.3,.5,0).multiplyScalar(size));",
"    v.light.target.position.copy(controls.target);v.light.target.updateMatrixWorld();",
"    renderer.setViewport(i*w/n,0,w/n,h);renderer.setScissor(i*w/n,0,w/n,h);renderer.render(v.scene,camera)})}",
"let size=0;views.forEach(function(v){",
"  const box=new THREE.Box3();for(let i=0;i<3*v.s.vertices;i+=3)",
"    box.expandByPoint(new THREE.Vector3(v.xyz[i],v.xyz[i+1],v.xyz[i+2]));",
"  v.size=box.getSize(new THREE.Vector3()).length();size=Math.max(size,v.size);box.getCenter(v.mesh.position)});",
"views.forEach(function(v){",              /* 10: the least ratio of two metric units, and too small to see */
"  v.times=v.size>0&&size/v.size>=10?size/v.size:1;",
"  v.mesh.scale.setScalar(v.times);v.mesh.position.multiplyScalar(-v.times);",
"  v.lines.scale.copy(v.mesh.scale);v.lines.position.copy(v.mesh.position)});",
"size=size||1;camera.near=size/1000;camera.far=size*20;camera.position.set(0,0,1.9*size);",
"views.forEach((v,i)=>document.getElementById('name'+'AB'[i]).textContent=views.length<2?'':",
"  v.s.name+(v.times>1?', drawn '+Number(v.times.toPrecision(3))+' times as large':''));",
"const names=[];DATA.surfaces.forEach(s=>s.fields.forEach(f=>names.includes(f.name)||names.push(f.name)));",
"const select=document.getElementById('field');[''].concat(names).forEach(function(n){",
"    const o=document.createElement('option');",
"  o.value=n;o.textContent=n||'none';select.appendChild(o)});select.value=DATA.channel;",
"const slider=document.getElementById('frame');slider.max=frames-1;",
"if(frames<2)['frames','frame','play'].forEach(i=>document.getElementById(i).style.display='none');",
"slider.oninput=()=>show(+slider.value);select.onchange=()=>show(+slider.value);",
"document.getElementById('edges').onchange=function(){views.forEach(v=>v.lines.visible=this.checked);draw()};",
"let timer=null;document.getElementById('play').onclick=function(){",
"  if(timer){clearInterval(timer);timer=null;this.textContent='play';return}this.textContent='stop';",
"  timer=setInterval(function(){slider.value=(+slider.value+1)%frames;show(+slider.value)},120)};",
"controls.addEventListener('change',draw);window.addEventListener('resize',draw);controls.update();show(0);",
NULL };

static void
put_lines(FILE *f, const char *const *line)
{
	for (; *line; line++)
		fprintf(f, "%s\n", *line);
}

/* Copies a script of the library. */
static void
put_library(FILE *f, const char *folder, const char *file)
{
	char *path = cmd_alloc(strlen(folder) + strlen(file) + 2, 1), *bytes;
	FILE *library;
	size_t n;

	sprintf(path, "%s/%s", folder, file);
	library = fopen(path, "rb");
	if (!library)
		die("%s is not there: install libjs-three, or name the folder of three.js: --three=DIR", path);
	fclose(library);
	bytes = cmd_slurp(path, &n);
	fputs("<script>\n", f);
	fwrite(bytes, 1, n, f);
	fputs("\n</script>\n", f);
	free(bytes);
	free(path);
}

static void
put_base64(FILE *f, const void *bytes, size_t n)
{
	enum { CHUNK = 3*4096 };
	char out[4*4096];
	const char *p = bytes;
	size_t k;

	putc('"', f);
	for (; n > 0; n -= k, p += k) {
		k = n < CHUNK ? n : CHUNK;
		base64_encode(p, k, out);
		fwrite(out, 1, base64_length(k), f);
	}
	putc('"', f);
}

static void
put_map(FILE *f, Colourmap map, int n)
{
	unsigned char b[3*257];
	int i;

	for (i = 0; i < n; i++) {
		Colour c = colourmap(map, i/(n - 1.0));

		b[3*i] = c.r, b[3*i+1] = c.g, b[3*i+2] = c.b;
	}
	put_base64(f, b, 3*(size_t)n);
}

/* The name of a file as a string; < would begin a tag, so it becomes _. */
static void
put_name(FILE *f, const char *name)
{
	char *copy = cmd_alloc(strlen(name) + 1, 1), *p;

	strcpy(copy, name);
	while ((p = strchr(copy, '<')))
		*p = '_';
	json_string(f, copy);
	free(copy);
}

static void
put_surface(FILE *f, const Shown *s)
{
	size_t n = (size_t)s->frames*(size_t)s->vertices;
	int k;

	fputs("{\"name\":", f);
	put_name(f, s->name);
	fprintf(f, ",\"vertices\":%d,\"frames\":%d,\"tri\":", s->vertices, s->frames);
	put_base64(f, s->tri, 3*(size_t)s->faces*sizeof *s->tri);
	fputs(",\"xyz\":", f);
	put_base64(f, s->xyz, 3*n*sizeof *s->xyz);
	fputs(",\"fields\":[", f);
	for (k = 0; k < s->fields; k++) {
		fprintf(f, "%s{\"name\":", k ? "," : "");
		json_string(f, s->field[k].name);
		fprintf(f, ",\"low\":%.9g,\"high\":%.9g,\"diverging\":%d,\"values\":", s->field[k].low, s->field[k].high,
		    s->field[k].diverging);
		put_base64(f, s->field[k].f, n*sizeof(float));
		putc('}', f);
	}
	fputs("]}", f);
}

void
page_write(FILE *f, const char *three, const Shown *a, const Shown *b, const char *channel)
{
	put_lines(f, head);
	put_library(f, three, "three.min.js");
	put_library(f, three, "examples/js/controls/OrbitControls.js");
	fputs("<script>\nconst DATA={\"channel\":", f);
	json_string(f, channel ? channel : "");
	fputs(",\"maps\":[", f);
	put_map(f, COLOURMAP_VIRIDIS, 256);
	putc(',', f);
	put_map(f, COLOURMAP_DIVERGING, 257);
	fputs("],\"surfaces\":[", f);
	put_surface(f, a);
	if (b) {
		putc(',', f);
		put_surface(f, b);
	}
	fputs("]};\n", f);
	put_lines(f, script);
	fputs("</script></body></html>\n", f);
}
