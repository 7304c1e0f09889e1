use grazing::number::*;
fn main(){
  let s=parse_rational("1/7").unwrap(); let a=Angle::new(&s);
  println!("{:?}", FloatInterval::sin(&a,&()));println!("{:?}", FloatInterval::cos(&a,&()));
  for b in [53u32,128,256,1024,4096,16384]{let p=Precision::new(b); let x=Ball::sin(&a,&p); let (l,h)=x.exact_bounds().unwrap();
   let f=FloatInterval::ratio(&l,&()); let g=FloatInterval::ratio(&h,&()); println!("{b} {:?} {:?} {:?}",f,g,x.certain_bits());
   let t=std::time::Instant::now(); for _ in 0..20{std::hint::black_box(Precision::new(b));} let tp=t.elapsed()/20;
   let n=if b>4000{20}else{2000}; let a=Angle::new(&parse_rational("12345/67891").unwrap());
   let t=std::time::Instant::now(); for _ in 0..n{std::hint::black_box(Ball::sin(std::hint::black_box(&a),&p));}
   let ts=t.elapsed()/n;
   let t=std::time::Instant::now(); for _ in 0..n/20{std::hint::black_box(Ball::sines(std::hint::black_box(&a),100,&p));}
   println!("pi {tp:?} sin {ts:?} sines/100 {:?}", t.elapsed()/(n/20)/100);
  }
  let a=Angle::new(&parse_rational("12345/67891").unwrap());
  let t=std::time::Instant::now(); for i in 0..1000000{std::hint::black_box(FloatInterval::sin(std::hint::black_box(&a.times(i)),&()));}
  println!("float sin {:?}", t.elapsed()/1000000);
  let t=std::time::Instant::now(); for i in 0..1000000{std::hint::black_box((i as f64*0.0123).sin());}
  println!("libm sin {:?}", t.elapsed()/1000000);
}
