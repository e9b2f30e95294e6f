/* The boundary between a module of UObjects and its host: plain C, so that any host can stand on the
   other side. Everything crosses it in an exchange: what is asked for, and buffers for values. */
#ifndef URBI_DETAIL_BOUNDARY_H
#define URBI_DETAIL_BOUNDARY_H

#include <stdint.h>

/* Modules and hosts of different numbers do not understand one another. */
#define URBI_BOUNDARY_VERSION 2

/* One call, in either direction. The caller provides both buffers. Where the reply does not fit, who
   answers allocates it by malloc and changes `reply`; who has called frees it. */
struct urbi_exchange
{
  int64_t operation;
  int64_t context; /* the UContext that the call is about */
  int64_t subject; /* object, variable, event or timer */
  uint8_t* data;   /* arguments */
  int64_t length;  /* bytes of arguments */
  uint8_t* reply;  /* result, or the text of an error */
  int64_t reply_capacity;
  int64_t reply_length;
};

/* What a host does for its modules: carries out an operation. Returns a number that depends on the
   operation, or URBI_FAILED. May be called from any thread. */
typedef int64_t (*urbi_host)(struct urbi_exchange*);

#define URBI_FAILED INT64_MIN

/* The operation of a call of the host that has failed because a request of the module had, and the
   module has let that pass. */
#define URBI_PASSED -1

/* What modules ask of their host: arguments -> result; reply. Texts and values are as in wire.hh. */
enum urbi_request
{
  URBI_OBJECT_NEW = 1,   /* name or "" -> id; name: C++ code has made an object by itself */
  URBI_OBJECT_GONE,      /* subject: C++ code has deleted an object */
  URBI_OBJECT_FIND,      /* name -> UObject* or 0, of whatever module */
  URBI_HUB_FIND,         /* name -> UObjectHub* or 0 */
  URBI_FUNCTION,         /* subject object; name, callback */
  URBI_EVERY,            /* subject object or hub; milliseconds, number after pass, callback -> timer */
  URBI_TIMER_END,        /* subject timer -> whether there was one */
  URBI_VARIABLE,         /* name, number whether it is a port -> variable */
  URBI_VARIABLE_CLOSE,   /* subject */
  URBI_VARIABLE_GET,     /* subject -> ; value */
  URBI_VARIABLE_SYNC,    /* subject -> ; value */
  URBI_VARIABLE_SET,     /* subject; value */
  URBI_VARIABLE_BYPASS,  /* subject; number on -> whether it can */
  URBI_VARIABLE_TIME,    /* subject -> microseconds */
  URBI_VARIABLE_IN,      /* subject -> ; number */
  URBI_VARIABLE_OUT,     /* subject -> ; number */
  URBI_VARIABLE_GET_PROPERTY, /* subject; number -> ; value */
  URBI_VARIABLE_SET_PROPERTY, /* subject; number, value */
  URBI_VARIABLE_OWN,     /* subject */
  URBI_VARIABLE_IS_OWNED,/* subject -> whether */
  URBI_VARIABLE_CHANGE,  /* subject; number object, callback */
  URBI_VARIABLE_ACCESS,  /* subject; number object, callback */
  URBI_VARIABLE_UNNOTIFY,/* subject */
  URBI_VARIABLE_KEEP,    /* subject: keep it synchronized */
  URBI_VARIABLE_RTP,     /* subject; number on */
  URBI_EVENT,            /* name -> event */
  URBI_EVENT_EMIT,       /* subject; values */
  URBI_EVENT_CLOSE,      /* subject */
  URBI_SEND,             /* text */
  URBI_CALL,             /* object, method, values */
  URBI_REPORT,           /* text */
  URBI_THREAD_LIMIT,     /* number */
  URBI_MODE,             /* -> 1 plugged, 2 remote; context 0: where the module is being loaded */
  URBI_CONVERT,          /* no context; value, value of the wanted kind, quality -> ; value */
  URBI_CHECK,            /* -> 0; asks for nothing: what a call costs */
  URBI_YIELD,            /* microseconds: waits while everything else goes on */
  URBI_LOCK,             /* nothing but what this thread asks for is done until URBI_UNLOCK */
  URBI_UNLOCK,
  URBI_CALLBACK_END,     /* subject object; address of a callback of a notification that ends */
  URBI_SERVER            /* -> port of the server that this process is connected to, or 0; host */
};

/* A callback, in arguments, is: its address, its arity, lock mode, queue size, all as int64_t; the
   mode is -1 for one that is not threaded.

   What a module exports:

     int64_t urbi_module_version(void)
       URBI_BOUNDARY_VERSION.
     int64_t urbi_module_open(urbi_host, struct urbi_exchange*)
       Tells it its host. Reply: for each class its kind ("class" or "hub") and its name.
     int64_t urbi_module_create(struct urbi_exchange*)
       operation: 0 for an object, 1 for a hub; subject: id of the object; data: class, name.
       Returns the address of the UObject or UObjectHub.
     int64_t urbi_module_destroy(struct urbi_exchange*)
       operation as above; subject: that address.
     int64_t urbi_module_invoke(struct urbi_exchange*)
       Calls the callback at the address `subject` with the values in data. Reply: its result.
     int64_t urbi_module_forget(struct urbi_exchange*)
       The context is no longer used. Returns whether all threads of the module itself have ended: 0 or 1.
     void urbi_module_free(void*)
       Frees a reply.

   All but the last return URBI_FAILED where an exception was thrown; the reply is its text.

   And only if it has code that yields:

     void urbi_module_yield(int64_t context, int64_t microseconds)
       Lets everything else go on for so long. The host does not call it: it sees by its presence that
       calls of the module may have to be left in the middle. */

#endif
