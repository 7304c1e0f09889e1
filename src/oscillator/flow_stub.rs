//! stub
use super::System;
use super::orbit::algebra::{Matrix2,apply};
/// s
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State { /// t
pub t: f64, /// q
pub q: f64, /// u
pub u: f64 }
/// f
pub trait Flow: Send+Sync {
    /// a
    fn advance(&self, from: State, duration: f64) -> State { self.advance_linearised(from, duration).0 }
    /// a
    fn advance_linearised(&self, from: State, duration: f64) -> (State, Matrix2);
    /// a
    fn acceleration(&self, state: State) -> f64;
}
struct L(System<f64>);
impl L { fn response(&self,t:f64)->[f64;2]{ let s=&self.0; let mut r=[if s.force==0.0{0.0}else{s.force/s.stiffness},0.0];
 for h in &s.forcing { let k=f64::from(h.k); let (re,im)=(s.stiffness-k*k,-k*s.damping); let sq=re*re+im*im; let(c,d)=((h.cos*re+h.sin*im)/sq,(h.sin*re-h.cos*im)/sq);
 let(si,co)=(k*t).sin_cos(); r[0]+=c*co+d*si; r[1]+=k*(d*co-c*si);} r } }
impl Flow for L {
    fn advance_linearised(&self, f: State, d: f64) -> (State, Matrix2) {
        let m=super::orbit::flow_matrix(self.0.damping,self.0.stiffness,d);
        let (a,b)=(self.response(f.t),self.response(f.t+d));
        let x=apply(&m,[f.q-a[0],f.u-a[1]]);
        (State{t:f.t+d,q:x[0]+b[0],u:x[1]+b[1]},m)
    }
    fn acceleration(&self, s: State) -> f64 { let y=&self.0; let f:f64=y.forcing.iter().map(|h|{let(a,b)=(f64::from(h.k)*s.t).sin_cos();h.cos*b+h.sin*a}).sum(); -y.damping*s.u-y.stiffness*s.q+y.force+f }
}
/// b
pub fn flow(system:&System<f64>)->crate::Result<Box<dyn Flow>>{Ok(Box::new(L(system.clone())))}
