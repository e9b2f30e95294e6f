/** From a stream of characters to complete statements. */
package org.urbi.lang.input;
