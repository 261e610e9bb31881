#include "app/cli/inspect_verb.h"
#include <iostream>
#include <cstring>
int main(int argc,char**argv){ kerf::app::InspectArguments a; a.model=argv[1]; for(int i=2;i<argc;++i){ if(!strcmp(argv[i],"--json")) a.json=true; if(!strcmp(argv[i],"--repair")) a.repaired=argv[++i]; else if(!strcmp(argv[i],"--remesh")) a.remeshed=argv[++i]; else if(!strcmp(argv[i],"--edge")) a.edge=atof(argv[++i]); }
 try { return kerf::app::inspectVerb(a,std::cout);} catch(const std::exception& e){ std::cerr<<e.what()<<"\n"; return 3;} }
